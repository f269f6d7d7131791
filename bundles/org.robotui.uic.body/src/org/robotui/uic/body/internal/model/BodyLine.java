package org.robotui.uic.body.internal.model;

import java.util.OptionalDouble;
import org.robotui.ui.Health;

/**
 * A line of the tree.
 *
 * @param key of it, always the same
 * @param depth how deep it lies
 * @param title its name
 * @param value what it says, on one line
 * @param number what it says where that is a number
 * @param age seconds since that came; NaN where nothing came
 * @param health its dot
 * @param below how many lines are in it
 * @param open whether those are seen
 */
public record BodyLine(String key, int depth, String title, String value, OptionalDouble number, double age,
    Health health, int below, boolean open) {}
