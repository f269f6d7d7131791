package org.robotui.ui.ask;

import java.util.OptionalDouble;
import java.util.OptionalInt;

/** Measures the messages of one topic: the last ten seconds of them, at most a fixed number. One thread. */
public final class Meter {
  /** How many messages it remembers at most. */
  public static final int CAPACITY = 4096;

  private static final long WINDOW_NANOS = 10_000_000_000L;
  private static final double NANO = 1e-9;
  private static final double PATIENCE_SECONDS = 1;
  private static final double PATIENCE_PERIODS = 5;

  private final long[] times = new long[CAPACITY];
  private final int[] sizes = new int[CAPACITY];
  private long count;
  private int kept;
  private boolean sized = true;

  /** Before the first message. */
  public Meter() {
    // Nothing came yet.
  }

  /**
   * A message came.
   *
   * @param receivedNanos {@link System#nanoTime()} when it came
   * @param size its bytes, where they are known
   */
  public void take(long receivedNanos, OptionalInt size) {
    int at = (int) (count % CAPACITY);
    times[at] = receivedNanos;
    sizes[at] = size.orElse(0);
    sized &= size.isPresent();
    count++;
    kept = Math.min(kept + 1, CAPACITY);
  }

  /**
   * What was measured.
   *
   * @param now {@link System#nanoTime()}
   * @return over the last ten seconds
   */
  public Measure measure(long now) {
    while (kept > 0 && now - time(0) > WINDOW_NANOS) {
      kept--;
    }
    if (kept < 2) {
      return new Measure(count > 1 ? 0 : Double.NaN, Double.NaN, Double.NaN, Double.NaN,
          silent(), sized && kept > 0 ? OptionalDouble.of(size(kept - 1)) : OptionalDouble.empty(), count);
    }
    return periods(now);
  }

  private OptionalDouble silent() {
    return sized && count > 1 ? OptionalDouble.of(0) : OptionalDouble.empty();
  }

  private Measure periods(long now) {
    double shortest = Double.POSITIVE_INFINITY;
    double longest = 0;
    double squares = 0;
    double bytes = size(0);
    double span = (time(kept - 1) - time(0)) * NANO;
    double mean = span / (kept - 1);
    for (int i = 1; i < kept; i++) {
      double period = (time(i) - time(i - 1)) * NANO;
      shortest = Math.min(shortest, period);
      longest = Math.max(longest, period);
      squares += (period - mean) * (period - mean);
      bytes += size(i);
    }
    boolean ended = (now - time(kept - 1)) * NANO > Math.max(PATIENCE_SECONDS, PATIENCE_PERIODS * mean);
    double hertz = ended || span <= 0 ? 0 : 1 / mean;
    double meanSize = bytes / kept;
    return new Measure(hertz, Math.sqrt(squares / (kept - 1)), shortest, longest,
        known(meanSize * hertz), known(meanSize), count);
  }

  private OptionalDouble known(double value) {
    return sized ? OptionalDouble.of(value) : OptionalDouble.empty();
  }

  private long time(int index) {
    return times[at(index)];
  }

  private int size(int index) {
    return sizes[at(index)];
  }

  private int at(int index) {
    return (int) ((count - kept + index) % CAPACITY);
  }
}
