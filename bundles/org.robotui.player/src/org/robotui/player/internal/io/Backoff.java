package org.robotui.player.internal.io;

import java.time.Duration;
import java.util.concurrent.ThreadLocalRandom;

/** The pauses between attempts: doubling up to a bound, with a quarter of jitter. For one thread. */
public final class Backoff {

  private final long minNanos;
  private final long maxNanos;
  private long nextNanos;

  public Backoff(Duration min, Duration max) {
    minNanos = min.toNanos();
    maxNanos = max.toNanos();
    nextNanos = minNanos;
  }

  public Duration next() {
    long base = nextNanos;
    nextNanos = Math.min(maxNanos, nextNanos * 2);
    double jitter = 0.75 + ThreadLocalRandom.current().nextDouble() * 0.5;
    return Duration.ofNanos(Math.min(maxNanos, (long) (base * jitter)));
  }

  public void reset() {
    nextNanos = minNanos;
  }
}
