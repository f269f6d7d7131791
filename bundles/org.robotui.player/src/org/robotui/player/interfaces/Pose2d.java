package org.robotui.player.interfaces;

/**
 * A place in the plane, or a velocity there (then per second).
 *
 * @param x forward, metres
 * @param y to the left, metres
 * @param yaw counter-clockwise, radians
 */
public record Pose2d(double x, double y, double yaw) {}
