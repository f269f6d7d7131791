package org.robotui.api.time;

/** Takes what a robot interface learns of its robot's clock. Methods never block. */
public interface ClockSource {
  /**
   * The robot lives in simulated time and it is now this; a jump back starts a new epoch.
   *
   * @param nanos simulated time
   */
  void simulated(long nanos);

  /**
   * The robot is a recording that is played, and this is the time in it. It is simulated time by which values grow old
   * as well: they stay as they are while it stands still, and how fast it passes does not matter. Must be said before
   * the first value is published.
   *
   * @param nanos time in the recording; not before the one that was said last, see {@link #moved}
   */
  default void replayed(long nanos) {
    simulated(nanos);
  }

  /**
   * As {@link #replayed}, where the recording was moved to another time, forward or back: a new epoch.
   *
   * @param nanos time in the recording
   */
  default void moved(long nanos) {
    replayed(nanos);
  }

  /**
   * When, by the clock of this machine, a recording was at a time: what is published again because it holds was
   * received then.
   *
   * @param nanos time in the recording
   * @return as {@link System#nanoTime()}; for a time before the recording was opened or moved, as if it had been played
   * at its own speed until then; for a later one than was said last, when that was
   */
  default long received(long nanos) {
    return System.nanoTime();
  }

  /** The robot lives in its own time again. */
  void live();

  /**
   * A stamp of the robot's clock was received: an observation for the offset estimate.
   *
   * @param stampNanos nanoseconds since 1970 by the robot's clock
   */
  void observed(long stampNanos);
}
