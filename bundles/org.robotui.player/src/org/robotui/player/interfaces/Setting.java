package org.robotui.player.interfaces;

/**
 * A number whose meaning is the driver's.
 *
 * @param value the number
 */
public record Setting(long value) {}
