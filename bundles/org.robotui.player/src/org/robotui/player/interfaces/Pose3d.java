package org.robotui.player.interfaces;

/**
 * A place in space, or a velocity there (then per second).
 *
 * @param x forward, metres
 * @param y to the left, metres
 * @param z up, metres
 * @param roll about x, radians
 * @param pitch about y, radians
 * @param yaw about z, radians
 */
public record Pose3d(double x, double y, double z, double roll, double pitch, double yaw) {}
