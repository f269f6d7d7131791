package org.robotui.net.call;

import java.time.Duration;
import java.util.concurrent.ThreadLocalRandom;

/** The pauses between attempts: doubling up to a bound, with a quarter of jitter. For one thread. */
public final class Backoff {

  private final long minNanos;
  private final long maxNanos;
  private long nextNanos;

  /**
   * Begins with the shortest pause.
   *
   * @param min the pause after the first failure, before jitter
   * @param max no pause is longer
   */
  public Backoff(Duration min, Duration max) {
    minNanos = min.toNanos();
    maxNanos = max.toNanos();
    nextNanos = minNanos;
  }

  /**
   * Counts a failure.
   *
   * @return how long to wait before the next attempt
   */
  public Duration next() {
    long base = nextNanos;
    nextNanos = Math.min(maxNanos, nextNanos * 2);
    double jitter = 0.75 + ThreadLocalRandom.current().nextDouble() * 0.5;
    return Duration.ofNanos(Math.min(maxNanos, (long) (base * jitter)));
  }

  /** An attempt succeeded: the next pause is the shortest again. */
  public void reset() {
    nextNanos = minNanos;
  }
}
