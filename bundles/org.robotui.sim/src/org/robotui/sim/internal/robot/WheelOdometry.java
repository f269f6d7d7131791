package org.robotui.sim.internal.robot;

import java.util.random.RandomGenerator;
import org.robotui.sim.internal.world.Pose2;

/** Dead reckoning from two wheels that measure with errors. For one thread. */
public final class WheelOdometry {
  private final OdometryErrors errors;
  private final Wheels wheels;
  private final RandomGenerator random;
  private Pose2 pose = Pose2.ORIGIN;
  private double leftAngle;
  private double rightAngle;

  public WheelOdometry(OdometryErrors errors, Wheels wheels, RandomGenerator random) {
    this.errors = errors;
    this.wheels = wheels;
    this.random = random;
  }

  /** Takes in a true motion. */
  public void moved(double distance, double turn) {
    leftAngle += (distance - turn * wheels.track() / 2) / wheels.radius();
    rightAngle += (distance + turn * wheels.track() / 2) / wheels.radius();
    double measured = distance * errors.distanceScale() + noise(distance);
    double turned = turn * errors.turnScale() + distance * errors.pull() + noise(turn);
    pose = pose.advance(measured, turned);
  }

  private double noise(double amount) {
    return amount == 0 ? 0 : errors.noise() * Math.sqrt(Math.abs(amount)) * random.nextGaussian();
  }

  /** In the odometry frame, which is where the robot was when it was last reset. */
  public Pose2 pose() {
    return pose;
  }

  /** Radians since the start. */
  public double leftAngle() {
    return leftAngle;
  }

  /** Radians since the start. */
  public double rightAngle() {
    return rightAngle;
  }

  /** Says from now on that the robot is there. */
  public void set(Pose2 there) {
    pose = there;
  }
}
