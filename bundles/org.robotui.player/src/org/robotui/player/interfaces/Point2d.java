package org.robotui.player.interfaces;

/**
 * A point in the plane.
 *
 * @param x forward, metres
 * @param y to the left, metres
 */
public record Point2d(double x, double y) {}
