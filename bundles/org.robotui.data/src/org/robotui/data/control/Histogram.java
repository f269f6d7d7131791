package org.robotui.data.control;

import java.util.List;
import java.util.stream.IntStream;
import org.robotui.data.internal.Check;

/**
 * How often durations occurred.
 *
 * @param counts how many fell into each bucket
 * @param lower least duration of each bucket, nanoseconds, rising; a bucket ends where the next begins, the last has no
 * end
 * @param max the longest, nanoseconds
 */
public record Histogram(List<Long> counts, List<Long> lower, long max) {
  /**
   * Copies the lists.
   *
   * @param counts how many fell into each bucket
   * @param lower least duration of each bucket
   * @param max the longest
   */
  public Histogram {
    counts = List.copyOf(counts);
    lower = List.copyOf(lower);
    Check.sizeIs(lower.size(), counts.size(), "lower");
  }

  /**
   * How many durations there were.
   *
   * @return the sum of all buckets
   */
  public long count() {
    return counts.stream().mapToLong(Long::longValue).sum();
  }

  /**
   * The duration that a share of all did not exceed, as far as the buckets tell: the end of the bucket it lies in.
   *
   * @param share 0 to 1, 0.99 for the 99th percentile
   * @return nanoseconds; NaN where there was none
   */
  public double percentile(double share) {
    long wanted = Math.max(1, (long) Math.ceil(share * count()));
    long seen = 0;
    for (int i = 0; i < counts.size(); i++) {
      seen += counts.get(i);
      if (seen >= wanted) {
        return i + 1 < lower.size() ? Math.min(lower.get(i + 1), max) : max;
      }
    }
    return Double.NaN;
  }

  /**
   * What came since an earlier reading of the same.
   *
   * @param earlier the earlier reading
   * @return the difference; the longest is that of all time, since buckets do not tell when it was
   */
  public Histogram since(Histogram earlier) {
    if (!earlier.lower.equals(lower)) {
      return this;
    }
    List<Long> more = IntStream.range(0, counts.size())
        .mapToObj(i -> Math.max(0, counts.get(i) - earlier.counts.get(i))).toList();
    return new Histogram(more, lower, max);
  }
}
