package org.robotui.foxglove;

/**
 * A named setting.
 *
 * @param name its name
 * @param value a tree of plain values, as of JSON
 */
public record Parameter(String name, Object value) {}
