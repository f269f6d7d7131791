package org.robotui.core.internal.host;

import java.time.Duration;

/**
 * How long the end may take at most.
 *
 * @param all of everything
 * @param each of the components of one RUIC; all RUICs end at the same time
 */
record ClosingTime(Duration all, Duration each) {
  /** The interfaces of a team end at once, but on as many processors as there are. */
  private static final Duration MORE = Duration.ofMillis(30);
  private static final int FEW = 10;
  private static final Duration LONGEST = Duration.ofSeconds(2);
  /** What core itself needs, beyond the limit of components, to find out what is left. */
  private static final Duration REPORTING = Duration.ofMillis(700);

  /**
   * Divides what there is.
   *
   * @param limit for everything, where there are few robot interfaces
   * @param interfaces how many run
   */
  static ClosingTime of(Duration limit, int interfaces) {
    Duration more = MORE.multipliedBy(Math.max(0, interfaces - FEW));
    Duration each = max(min(limit.minus(REPORTING), LONGEST), REPORTING);
    return new ClosingTime(limit.plus(more), each.plus(more));
  }

  private static Duration max(Duration a, Duration b) {
    return a.compareTo(b) > 0 ? a : b;
  }

  private static Duration min(Duration a, Duration b) {
    return a.compareTo(b) < 0 ? a : b;
  }
}
