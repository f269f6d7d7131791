package org.robotui.sim.internal;

import org.robotui.sim.internal.robot.DriveLimits;
import org.robotui.sim.internal.robot.OdometryErrors;
import org.robotui.sim.internal.sensor.LaserSpec;

/**
 * What a simulation can be started with.
 *
 * @param seed of all noise
 * @param limits of the drive
 * @param odometryErrors of the wheels
 * @param laser the scanner
 * @param batteryLevel at the start, 0 to 1
 */
public record Settings(
    long seed, DriveLimits limits, OdometryErrors odometryErrors, LaserSpec laser, double batteryLevel) {
  public static Settings demo(long seed) {
    return new Settings(seed, DriveLimits.DEMO, OdometryErrors.DEMO, LaserSpec.DEMO, 0.87);
  }

  public Settings withLimits(DriveLimits other) {
    return new Settings(seed, other, odometryErrors, laser, batteryLevel);
  }
}
