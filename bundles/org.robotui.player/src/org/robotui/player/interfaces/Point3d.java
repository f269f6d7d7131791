package org.robotui.player.interfaces;

/**
 * A point in space.
 *
 * @param x forward, metres
 * @param y to the left, metres
 * @param z up, metres
 */
public record Point3d(double x, double y, double z) {}
