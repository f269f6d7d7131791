package org.robotui.player.interfaces;

/**
 * How large something flat is.
 *
 * @param width across, metres
 * @param length along, metres
 */
public record Size2d(double width, double length) {}
