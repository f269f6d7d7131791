package org.robotui.player.interfaces;

/**
 * How large something is.
 *
 * @param width across, metres
 * @param length along, metres
 * @param height up, metres
 */
public record Size3d(double width, double length, double height) {}
