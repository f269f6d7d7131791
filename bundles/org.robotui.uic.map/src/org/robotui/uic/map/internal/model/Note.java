package org.robotui.uic.map.internal.model;

import org.robotui.ui.Health;

/**
 * A small line about a layer.
 *
 * @param health its dot
 * @param text for example {@code scan: no transform odom ← laser: ...}
 */
public record Note(Health health, String text) {}
