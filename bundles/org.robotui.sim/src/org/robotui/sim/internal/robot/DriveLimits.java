package org.robotui.sim.internal.robot;

/**
 * What the drive can do; all positive.
 *
 * @param linear metres per second
 * @param angular radians per second
 * @param linearAcceleration metres per second squared; braking is twice as strong
 * @param angularAcceleration radians per second squared; braking is twice as strong
 */
public record DriveLimits(double linear, double angular, double linearAcceleration, double angularAcceleration) {
  public static final DriveLimits DEMO = new DriveLimits(0.7, 1.8, 0.9, 4.0);

  public DriveLimits {
    if (!(linear > 0 && angular > 0 && linearAcceleration > 0 && angularAcceleration > 0)) {
      throw new IllegalArgumentException("drive limits must be positive");
    }
  }

  public Speed clamp(Speed wish) {
    return new Speed(
        Math.clamp(wish.linear(), -linear, linear), Math.clamp(wish.angular(), -angular, angular));
  }
}
