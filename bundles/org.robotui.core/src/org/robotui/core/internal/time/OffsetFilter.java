package org.robotui.core.internal.time;

import java.util.Arrays;
import java.util.OptionalLong;

/**
 * Estimates a clock offset from one-way messages. Each observation is offset plus delay, and delays are never negative,
 * so the minimum over a window is the offset plus the shortest delay.
 */
final class OffsetFilter {
  private static final int BUCKETS = 12;
  private static final long BUCKET_NANOS = 5_000_000_000L;

  private final long[] ids = new long[BUCKETS];
  private final long[] minima = new long[BUCKETS];

  OffsetFilter() {
    Arrays.fill(ids, Long.MIN_VALUE);
  }

  /** Adds an observation: our time of receipt minus the stamp. */
  synchronized void observe(long nowNanos, long difference) {
    long id = Math.floorDiv(nowNanos, BUCKET_NANOS);
    int slot = (int) Math.floorMod(id, (long) BUCKETS);
    minima[slot] = ids[slot] == id ? Math.min(minima[slot], difference) : difference;
    ids[slot] = id;
  }

  /**
   * The minimum over the last minute. Where that minute was silent, the last one known stays: a robot's clock does not
   * change because it says nothing.
   */
  synchronized OptionalLong minimum(long nowNanos) {
    long newest = Arrays.stream(ids).max().orElse(Long.MIN_VALUE);
    long oldest = Math.min(newest, Math.floorDiv(nowNanos, BUCKET_NANOS)) - BUCKETS;
    OptionalLong found = OptionalLong.empty();
    for (int i = 0; newest != Long.MIN_VALUE && i < BUCKETS; i++) {
      if (ids[i] != Long.MIN_VALUE && ids[i] > oldest) {
        found = OptionalLong.of(Math.min(found.orElse(Long.MAX_VALUE), minima[i]));
      }
    }
    return found;
  }

  synchronized void clear() {
    Arrays.fill(ids, Long.MIN_VALUE);
  }
}
