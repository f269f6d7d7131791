package org.robotui.uic.plugins.internal.model;

import java.util.Optional;
import org.robotui.data.control.Histogram;

/**
 * What a histogram tells in three figures.
 *
 * @param histogram the whole
 * @param p50 what half did not exceed, nanoseconds; NaN where there was none
 * @param p99 what 99 of 100 did not exceed
 * @param max the longest
 * @param bound whether the longest is only known not to exceed that
 */
public record Evidence(Histogram histogram, double p50, double p99, double max, boolean bound) {
  private static final double HALF = 0.5;
  private static final double MOST = 0.99;

  /** Since the start, or since an earlier reading. */
  public static Evidence of(Histogram now, Optional<Histogram> earlier) {
    // A process that was started again counts from zero: what was before is no part of it.
    Optional<Histogram> before = earlier.filter(e -> e.count() <= now.count() && e.lower().equals(now.lower()));
    if (before.isEmpty()) {
      return of(now, now.count() == 0 ? Double.NaN : now.max(), false);
    }
    Histogram since = now.since(before.get());
    boolean grew = now.max() > before.get().max();
    return of(since, grew ? now.max() : end(since), !grew);
  }

  private static Evidence of(Histogram histogram, double max, boolean bound) {
    return new Evidence(histogram, Math.min(histogram.percentile(HALF), max), Math.min(histogram.percentile(MOST), max),
        max, bound);
  }

  /** The end of the highest bucket in which there is anything; NaN where all are empty. */
  private static double end(Histogram histogram) {
    for (int i = histogram.counts().size() - 1; i >= 0; i--) {
      if (histogram.counts().get(i) > 0) {
        boolean last = i + 1 == histogram.lower().size();
        return last ? histogram.max() : Math.min(histogram.max(), histogram.lower().get(i + 1));
      }
    }
    return Double.NaN;
  }

  /** The longest as users read it. */
  public String longest() {
    return (bound && !Double.isNaN(max) ? "\u2264\u00a0" : "") + Durations.of(max);
  }

  /** Whether there is anything to tell. */
  public boolean isEmpty() {
    return histogram.count() == 0;
  }

  /** How much of a period the longest took; NaN where that is not known. */
  public double share(long period) {
    return period > 0 ? max / period : Double.NaN;
  }
}
