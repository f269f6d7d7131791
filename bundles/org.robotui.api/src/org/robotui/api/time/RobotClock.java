package org.robotui.api.time;

import java.time.Duration;
import java.util.Optional;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;

/** The clock of one robot. Safe for all threads. */
public interface RobotClock {
  /**
   * The time.
   *
   * @return now, on this clock
   */
  Stamp now();

  /**
   * Whose clock this is at the moment.
   *
   * @return the kind
   */
  ClockKind kind();

  /**
   * How far the robot's clock is ahead of ours, as estimated from received stamps.
   *
   * @return the offset, or none where nothing stamped came yet
   */
  Optional<Duration> offset();

  /**
   * How often the clock has jumped back, or a recording was moved. A consumer that sees a new number forgets what it
   * has accumulated.
   *
   * @return 0 before the first jump
   */
  long epoch();

  /**
   * The time by which values grow old: that of this machine, for a recording its own, which may stand still, pass
   * quickly, and begin anew with an epoch. Only differences mean something.
   *
   * @param nanos a moment of this machine that has come, as {@link System#nanoTime()}
   * @return the same moment in that time, nanoseconds
   */
  default long agingNanos(long nanos) {
    return nanos;
  }

  /**
   * How long ago something was received, by that time.
   *
   * @param receivedNanos when, as {@link System#nanoTime()}
   * @param nowNanos now, as {@link System#nanoTime()}
   * @return seconds, not negative
   */
  default double ageSeconds(long receivedNanos, long nowNanos) {
    return Math.max(0, agingNanos(nowNanos) - agingNanos(receivedNanos)) * 1e-9;
  }
}
