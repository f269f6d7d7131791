package org.robotui.api.time;

/** Takes what a robot interface learns of its robot's clock. Methods never block. */
public interface ClockSource {
  /**
   * The robot lives in simulated time and it is now this; a jump back starts a new epoch.
   *
   * @param nanos simulated time
   */
  void simulated(long nanos);

  /** The robot lives in its own time again. */
  void live();

  /**
   * A stamp of the robot's clock was received: an observation for the offset estimate.
   *
   * @param stampNanos nanoseconds since 1970 by the robot's clock
   */
  void observed(long stampNanos);
}
