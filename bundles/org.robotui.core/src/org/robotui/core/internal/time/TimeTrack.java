package org.robotui.core.internal.time;

/**
 * Which time of a recording it was at which moment of this machine, for the last minutes. Between two moments that are
 * kept it is taken to have passed evenly; before the first one at its own speed. Not safe for several threads.
 */
final class TimeTrack {
  /** Finer than a user sees ages, and at this grain ten minutes are kept. */
  private static final long GRAIN_NANOS = 100_000_000L;
  private static final int MOST = 6000;

  private final long[] moments = new long[MOST];
  private final long[] times = new long[MOST];
  private int first;
  private int size;

  /** Nothing holds any more but this. */
  void begin(long moment, long time) {
    size = 0;
    append(moment, time);
  }

  /** Both not before those that were said last. */
  void add(long moment, long time) {
    boolean within = size > 1 && moment - moments[index(size - 2)] < GRAIN_NANOS;
    if (within) {
      size--;
    }
    append(moment, time);
  }

  private void append(long moment, long time) {
    if (size == MOST) {
      first = (first + 1) % MOST;
      size--;
    }
    moments[index(size)] = moment;
    times[index(size)] = time;
    size++;
  }

  private int index(int number) {
    return (first + number) % MOST;
  }

  /** The time of the recording at a moment; that of the last one for later ones. Something was said before. */
  long time(long moment) {
    return between(moments, times, moment);
  }

  /** The moment at which a recording was at a time; the last one for later ones. Something was said before. */
  long moment(long time) {
    return between(times, moments, time);
  }

  private long between(long[] from, long[] to, long value) {
    int after = firstAfter(from, value);
    if (after == size) {
      return to[index(size - 1)];
    }
    int end = index(after);
    if (after == 0) {
      return to[end] - (from[end] - value);
    }
    int begin = index(after - 1);
    double part = (value - from[begin]) / (double) (from[end] - from[begin]);
    return to[begin] + Math.round(part * (to[end] - to[begin]));
  }

  /** The number of the first that is greater; the moments of a machine may begin anywhere, also below zero. */
  private int firstAfter(long[] of, long value) {
    int low = 0;
    int high = size;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (of[index(middle)] - value > 0) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  }
}
