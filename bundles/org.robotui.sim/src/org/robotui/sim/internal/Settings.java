package org.robotui.sim.internal;

import org.robotui.sim.internal.model.RobotModel;
import org.robotui.sim.internal.model.Robots;
import org.robotui.sim.internal.robot.DriveLimits;
import org.robotui.sim.internal.sensor.LaserSpec;

/**
 * What a simulation can be started with.
 *
 * @param seed of all noise
 * @param robot which robot
 * @param limits of its drive
 * @param batteryLevel at the start, 0 to 1
 */
public record Settings(long seed, RobotModel robot, DriveLimits limits, double batteryLevel) {
  private static final double BATTERY = 0.87;

  public static Settings of(RobotModel robot, long seed) {
    return new Settings(seed, robot, robot.limits(), BATTERY);
  }

  public static Settings demo(long seed) {
    return of(Robots.NATALIE, seed);
  }

  public Settings withLimits(DriveLimits other) {
    return new Settings(seed, robot, other, batteryLevel);
  }

  public LaserSpec laser() {
    return robot.laser();
  }
}
