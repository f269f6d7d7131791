package org.robotui.uic.plot.internal.model;

import org.robotui.api.port.Envelope;
import org.robotui.api.time.RobotClock;

/**
 * Places values in time, nanoseconds since 1970: by their stamps, or by their receipt on this machine's clock. Worker
 * only.
 */
final class SampleClock {
  private static final long TRUSTED = 2_000_000_000L;

  private final RobotClock clock;
  private final long startOffset;
  private boolean byStamp = true;
  private long ahead;
  private long newest = Long.MIN_VALUE;

  SampleClock(RobotClock clock, long wallNanos, long monotonicNanos) {
    this.clock = clock;
    this.startOffset = wallNanos - monotonicNanos;
  }

  /** Begins anew. */
  void reset(boolean stamps) {
    byStamp = stamps;
    newest = Long.MIN_VALUE;
    ahead = 0;
  }

  /** When a value was true. One without a stamp was when it was received. */
  long timeOf(Envelope<?> envelope, long nowNanos) {
    long time = byStamp
        ? envelope.stamp().map(s -> s.nanos())
            .orElseGet(() -> clock.now().nanos() - (nowNanos - envelope.receivedNanos()))
        : startOffset + envelope.receivedNanos();
    newest = Math.max(newest, time);
    return time;
  }

  /** After values came: sees how far the robot's clock is from their stamps. */
  void arrived() {
    long difference = clock.now().nanos() - newest;
    // A small difference is the way of the values; a large one means that the stamps are not of that clock.
    ahead = Math.abs(difference) < TRUSTED ? 0 : difference;
  }

  /** The time at the right end while live; it goes on while nothing comes, as the clock does. */
  long now(long nowNanos) {
    return byStamp ? Math.max(newest, clock.now().nanos() - ahead) : Math.max(newest, startOffset + nowNanos);
  }
}
