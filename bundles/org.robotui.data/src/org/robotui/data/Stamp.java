package org.robotui.data;

import java.time.Duration;

/**
 * A point in time on a named clock.
 *
 * @param nanos nanoseconds since the epoch of that clock (1970 for wall and robot)
 * @param clock whose clock
 */
public record Stamp(long nanos, ClockKind clock) implements Comparable<Stamp> {
  private static final long NANOS_PER_SECOND = 1_000_000_000L;

  /**
   * A stamp from seconds and nanoseconds.
   *
   * @param seconds whole seconds
   * @param nanos nanoseconds within the second
   * @param clock whose clock
   * @return the stamp
   */
  public static Stamp of(long seconds, long nanos, ClockKind clock) {
    return new Stamp(seconds * NANOS_PER_SECOND + nanos, clock);
  }

  /**
   * The time from another stamp to this one.
   *
   * @param earlier a stamp of the same clock
   * @return the difference, negative where the other is later
   * @throws IllegalArgumentException where the clocks differ: their difference means nothing
   */
  public Duration since(Stamp earlier) {
    if (clock != earlier.clock) {
      throw new IllegalArgumentException("stamps of different clocks: " + clock + " and " + earlier.clock);
    }
    return Duration.ofNanos(nanos - earlier.nanos);
  }

  /**
   * The stamp in seconds, for display: a double keeps microseconds of today's time.
   *
   * @return seconds since the epoch of the clock
   */
  public double seconds() {
    return nanos / (double) NANOS_PER_SECOND;
  }

  @Override
  public int compareTo(Stamp other) {
    return Long.compare(nanos, other.nanos);
  }
}
