package org.robotui.sim.internal.robot;

/**
 * Two driven wheels on one axis through the robot's centre.
 *
 * @param radius of each, metres
 * @param track from one to the other, metres
 */
public record Wheels(double radius, double track) {}
