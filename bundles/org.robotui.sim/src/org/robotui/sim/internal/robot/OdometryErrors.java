package org.robotui.sim.internal.robot;

/**
 * How wrong the wheels measure.
 *
 * @param distanceScale factor on distances; 1 is right
 * @param turnScale factor on angles; 1 is right
 * @param pull radians of false turn a metre driven
 * @param noise standard deviation relative to the square root of the distance (m) or angle (rad)
 */
public record OdometryErrors(double distanceScale, double turnScale, double pull, double noise) {
  public static final OdometryErrors NONE = new OdometryErrors(1, 1, 0, 0);
  public static final OdometryErrors DEMO = new OdometryErrors(1.008, 0.994, 0.006, 0.004);
}
