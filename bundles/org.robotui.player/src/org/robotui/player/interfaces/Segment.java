package org.robotui.player.interfaces;

/**
 * A straight line.
 *
 * @param x0 where it begins, metres
 * @param y0 where it begins, metres
 * @param x1 where it ends, metres
 * @param y1 where it ends, metres
 */
public record Segment(double x0, double y0, double x1, double y1) {}
