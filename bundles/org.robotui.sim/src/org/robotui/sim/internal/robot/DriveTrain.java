package org.robotui.sim.internal.robot;

/** Follows a wished speed within the limits of speed and acceleration. For one thread. */
public final class DriveTrain {
  private static final double BRAKING = 2;

  private DriveLimits limits;
  private Speed speed = Speed.ZERO;

  public DriveTrain(DriveLimits limits) {
    this.limits = limits;
  }

  /** Changes the limits from now on. */
  public void limit(DriveLimits other) {
    limits = other;
  }

  public Speed speed() {
    return speed;
  }

  /** The speed after {@code dt} seconds. */
  public Speed approach(Speed wish, double dt) {
    Speed target = limits.clamp(wish);
    speed = new Speed(
        approach(speed.linear(), target.linear(), limits.linearAcceleration() * dt),
        approach(speed.angular(), target.angular(), limits.angularAcceleration() * dt));
    return speed;
  }

  private static double approach(double now, double target, double step) {
    boolean slowing = Math.abs(target) < Math.abs(now) || target * now < 0;
    double most = slowing ? BRAKING * step : step;
    return now + Math.clamp(target - now, -most, most);
  }

  /** As if the robot had run into something. */
  public void halt() {
    speed = Speed.ZERO;
  }

  /** Forward motion is taken away, turning goes on. */
  public void block() {
    speed = new Speed(0, speed.angular());
  }
}
