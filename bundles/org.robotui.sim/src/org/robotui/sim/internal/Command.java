package org.robotui.sim.internal;

import org.robotui.sim.internal.robot.Neck;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Pose2;

/** What can be asked of the robot. */
public sealed interface Command {
  /**
   * Drive at a speed; ends navigation.
   *
   * @param hold seconds after which it stops unless it is told again
   */
  record Drive(Speed speed, double hold) implements Command {
    /** For half a second. */
    public Drive(Speed speed) {
      this(speed, 0.5);
    }
  }

  /**
   * Drive straight to a place, avoiding nothing; ends navigation.
   *
   * @param pose in the odometry frame
   * @param most the speeds not to be exceeded
   */
  record Approach(Pose2 pose, Speed most) implements Command {}

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

  /** Let odometry say from now on that it is there; what localisation believes stays. */
  record SetOdometry(Pose2 pose) implements Command {}

  /** Look somewhere. */
  record Turn(Neck.Look look) implements Command {}

  /** Switch the motors. */
  record Motors(boolean on) implements Command {}

  /** Stop, and forget the goal. */
  record Stop() implements Command {}

  /** Back to the start, as new. */
  record Reset() implements Command {}
}
