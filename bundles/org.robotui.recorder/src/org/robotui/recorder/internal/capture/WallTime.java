package org.robotui.recorder.internal.capture;

import java.time.Instant;

/**
 * Makes times of the day of what was measured by the monotonic clock. Where somebody sets the clock of the machine
 * meanwhile, that does not reorder what is recorded.
 *
 * @param startNanos {@link System#nanoTime()} when it began
 * @param startTime nanoseconds since 1970 at that moment
 */
public record WallTime(long startNanos, long startTime) {
  private static final long SECOND = 1_000_000_000L;

  /** Begins now. */
  public static WallTime begin() {
    Instant now = Instant.now();
    return new WallTime(System.nanoTime(), now.getEpochSecond() * SECOND + now.getNano());
  }

  /** Nanoseconds since 1970 of a moment of the monotonic clock. */
  public long of(long nanos) {
    return startTime + (nanos - startNanos);
  }

  /** Nanoseconds since 1970. */
  public long now() {
    return of(System.nanoTime());
  }
}
