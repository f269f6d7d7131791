package org.robotui.sim.internal;

import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Pose2;

/** What can be asked of the robot. */
public sealed interface Command {
  /** Drive at a speed, for half a second; ends navigation. */
  record Drive(Speed speed) implements Command {}

  /**
   * Drive to a place in the map.
   *
   * @param id names the goal
   */
  record Goal(String id, Pose2 pose) implements Command {}

  /** Give up the goal of this name, if it is the present one. */
  record Cancel(String id) implements Command {}

  /** Change how it drives from now on. */
  record Tune(Tuning tuning) implements Command {}

  /** Believe to be at a place in the map. */
  record InitialPose(Pose2 pose) implements Command {}

  /** Switch the motors. */
  record Motors(boolean on) implements Command {}

  /** Stop, and forget the goal. */
  record Stop() implements Command {}

  /** Back to the start, as new. */
  record Reset() implements Command {}
}
