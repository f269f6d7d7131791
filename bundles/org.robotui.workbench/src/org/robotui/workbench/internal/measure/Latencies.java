package org.robotui.workbench.internal.measure;

import java.util.concurrent.atomic.AtomicLongArray;

/** How long things took, in classes that are two percent wide: bounded memory, any number of threads. */
public final class Latencies {
  private static final double STEP = Math.log(1.02);
  private static final int CLASSES = 1200;

  private final AtomicLongArray counts = new AtomicLongArray(CLASSES);

  /** Adds a duration. */
  public void add(long nanos) {
    double microseconds = Math.max(1, nanos / 1e3);
    counts.incrementAndGet((int) Math.min(CLASSES - 1, Math.log(microseconds) / STEP));
  }

  /** How many were added. */
  public long count() {
    long sum = 0;
    for (int i = 0; i < CLASSES; i++) {
      sum += counts.get(i);
    }
    return sum;
  }

  /** The duration, in milliseconds, that this share of all did not exceed; 0 where there are none. */
  public double percentile(double share) {
    long left = (long) Math.ceil(share * count());
    for (int i = 0; i < CLASSES; i++) {
      left -= counts.get(i);
      if (left <= 0 && counts.get(i) > 0) {
        return Math.exp((i + 1) * STEP) / 1e3;
      }
    }
    return 0;
  }
}
