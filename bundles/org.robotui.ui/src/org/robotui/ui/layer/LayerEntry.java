package org.robotui.ui.layer;

import org.robotui.api.config.Settings;
import org.robotui.ui.scene.Ink;

/**
 * What the list of layers says of one.
 *
 * @param name for users
 * @param number how many of its kind lie below it
 * @param count how many of its kind there are, itself included
 * @param ink its colour: one that the user has chosen, else that of its robot where there are several, else its usual
 * one
 * @param settings checked
 */
public record LayerEntry(String name, int number, int count, Ink ink, Settings settings) {}
