package org.robotui.api.time;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicLongArray;

/**
 * Measures how often something happens. Marking is lock-free and allocates nothing. Fast streams are counted in slots
 * of 100 ms over five seconds, so that bursts do not matter; for slow ones the intervals between the last values say
 * more. Safe for all threads.
 */
public final class RateMeter {
  private static final double SECONDS = 1e-9;
  private static final long SLOT_NANOS = 100_000_000L;
  private static final int SLOTS = 50;
  private static final int COUNT_BITS = 24;
  private static final long COUNT_MASK = (1L << COUNT_BITS) - 1;
  private static final int TIMES = 16;
  private static final long ENOUGH = 20;

  private final long birth;
  private final AtomicLongArray slots = new AtomicLongArray(SLOTS);
  private final AtomicLongArray times = new AtomicLongArray(TIMES);
  private final AtomicLong count = new AtomicLong();
  /** How many of them have their time written. */
  private final AtomicLong timed = new AtomicLong();
  /** Every view asks with every tick, and most ask about a value that they have asked about before. */
  private volatile Typical typical = new Typical(0, 0);

  private record Typical(long count, double seconds) {}

  /**
   * Starts counting.
   *
   * @param now a moment of a clock that does not go back, nanoseconds; later ones are of the same clock
   */
  public RateMeter(long now) {
    birth = now - SLOT_NANOS;
  }

  /**
   * Counts one.
   *
   * @param now when it happened
   */
  public void mark(long now) {
    long id = slotId(now);
    slots.accumulateAndGet((int) (id % SLOTS), id, RateMeter::increment);
    times.set((int) (count.getAndIncrement() % TIMES), now);
    timed.incrementAndGet();
  }

  private long slotId(long now) {
    return Math.max(1, (now - birth) / SLOT_NANOS);
  }

  private static long increment(long slot, long id) {
    boolean same = slot >>> COUNT_BITS == id && (slot & COUNT_MASK) < COUNT_MASK;
    return same ? slot + 1 : id << COUNT_BITS | 1;
  }

  /**
   * How many there were.
   *
   * @return since the start
   */
  public long count() {
    return count.get();
  }

  /**
   * How many there are in a second.
   *
   * @param now the time
   * @return the rate; 0 where that cannot be told
   */
  public double rateHz(long now) {
    return count.get() == 0 ? 0 : rateOf(now);
  }

  private double rateOf(long now) {
    long newest = slotId(now) - 1;
    long sum = 0;
    long oldest = newest;
    for (int i = 0; i < SLOTS; i++) {
      long id = slots.get(i) >>> COUNT_BITS;
      if (id > 0 && id <= newest && id > newest - SLOTS + 1) {
        sum += slots.get(i) & COUNT_MASK;
        oldest = Math.min(oldest, id);
      }
    }
    boolean young = count.get() <= sum + ENOUGH;
    long window = young ? newest - oldest + 1 : SLOTS - 1;
    return sum >= ENOUGH ? sum / (window * SLOT_NANOS * SECONDS) : fromIntervals(now);
  }

  private double fromIntervals(long now) {
    double period = typicalPeriodSeconds();
    double age = (now - newestTime()) * SECONDS;
    return period > 0 && age < 3 * period + 1 ? 1 / Math.max(period, age / 2) : 0;
  }

  private long newestTime() {
    long n = count.get();
    return n == 0 ? birth : times.get((int) ((n - 1) % TIMES));
  }

  /**
   * How far they are apart, as a rule.
   *
   * @return the median interval between the last ones; 0 where there were fewer than two
   */
  public double typicalPeriodSeconds() {
    long present = timed.get();
    Typical known = typical;
    if (known.count() != present) {
      known = new Typical(present, medianGap((int) Math.min(present, TIMES)) * SECONDS);
      typical = known;
    }
    return known.seconds();
  }

  private double medianGap(int n) {
    if (n < 2) {
      return 0;
    }
    long[] sorted = new long[n];
    Arrays.setAll(sorted, times::get);
    Arrays.sort(sorted);
    long[] gaps = new long[n - 1];
    Arrays.setAll(gaps, i -> sorted[i + 1] - sorted[i]);
    Arrays.sort(gaps);
    return gaps[gaps.length / 2];
  }
}
