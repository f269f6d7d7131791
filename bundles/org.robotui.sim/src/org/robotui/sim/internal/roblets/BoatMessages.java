package org.robotui.sim.internal.roblets;

import org.robotui.roblets.tree.BodyMessage;
import org.robotui.roblets.tree.BodyUnit;

/** What roblets of the simulated robots say and take. */
final class BoatMessages {
  private BoatMessages() {}

  @BodyMessage(as = "gpsfix")
  record Position(@BodyUnit("deg") double latitude, @BodyUnit("deg") double longitude, @BodyUnit("m") double accuracy,
      @BodyUnit("m/s") double speed) {}

  /** From north over east. */
  @BodyMessage(as = "heading")
  record Heading(@BodyUnit("deg") double heading, @BodyUnit("deg/s") double rate) {}

  /** From where it blows, seen from the bow. */
  record Wind(@BodyUnit("m/s") double speed, @BodyUnit("deg") double angle) {}

  /** Positive turns to starboard. */
  record Turn(@BodyUnit("deg") double angle) {}

  record Thrust(double throttle) {}

  record Power(double throttle, @BodyUnit("1/min") double turns) {}

  @BodyMessage(as = "battery")
  record Charge(@BodyUnit("V") double voltage, @BodyUnit("A") double current, double charge) {}

  @BodyMessage(as = "odometry")
  record Motion(@BodyUnit("m") double x, @BodyUnit("m") double y, @BodyUnit("rad") double yaw,
      @BodyUnit("m/s") double vx, @BodyUnit("m/s") double vy, @BodyUnit("rad/s") double wz) {}

  @BodyMessage(as = "pose")
  record Place(@BodyUnit("m") double x, @BodyUnit("m") double y, @BodyUnit("rad") double yaw) {}

  @BodyMessage(as = "velocity")
  record Velocity(@BodyUnit("m/s") double vx, @BodyUnit("m/s") double vy, @BodyUnit("rad/s") double wz) {}

  /** Whether the brain steers by its marks, or somebody by hand. */
  record Autopilot(boolean on) {}

  record Order(boolean autopilot, @BodyUnit("m/s") double speed, @BodyUnit("rad/s") double turn) {}

  record HeartBeat(long beat) {}
}
