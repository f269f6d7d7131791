package org.robotui.sim.internal.nav;

import org.robotui.sim.internal.robot.Speed;

/** What navigation wants next. */
public sealed interface Progress {
  /** There is no goal. */
  record Idle() implements Progress {}

  /**
   * On the way.
   *
   * @param speed to drive with
   */
  record Driving(Speed speed) implements Progress {}

  /** The goal has just been reached. */
  record Reached() implements Progress {}

  /**
   * The goal has just been given up.
   *
   * @param reason for a user
   */
  record Aborted(String reason) implements Progress {}
}
