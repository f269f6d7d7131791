package org.robotui.player.interfaces;

/**
 * An orientation in space, or its change.
 *
 * @param roll about x, radians
 * @param pitch about y, radians
 * @param yaw about z, radians
 */
public record Angles(double roll, double pitch, double yaw) {}
