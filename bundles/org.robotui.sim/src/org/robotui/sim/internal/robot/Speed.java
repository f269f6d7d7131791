package org.robotui.sim.internal.robot;

/**
 * A speed in the plane, as a differential drive can have it.
 *
 * @param linear metres per second, forward
 * @param angular radians per second, counter-clockwise
 */
public record Speed(double linear, double angular) {
  public static final Speed ZERO = new Speed(0, 0);

  public boolean isZero() {
    return linear == 0 && angular == 0;
  }

  public boolean isFinite() {
    return Double.isFinite(linear) && Double.isFinite(angular);
  }
}
