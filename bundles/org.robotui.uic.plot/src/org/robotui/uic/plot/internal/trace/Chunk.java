package org.robotui.uic.plot.internal.trace;

/** A run of samples, only ever added to, with a pyramid over them. Times never fall. Not safe for threads by itself. */
final class Chunk {
  static final int SIZE = 4096;

  private static final int FAN = 16;

  private final long[] times = new long[SIZE];
  private final double[] values = new double[SIZE];
  private final Level fine = new Level(SIZE, FAN);
  private final Level coarse = new Level(SIZE, FAN * FAN);
  private final Level whole = new Level(SIZE, SIZE);
  private int count;

  boolean isFull() {
    return count == SIZE;
  }

  int count() {
    return count;
  }

  void add(long time, double value) {
    times[count] = time;
    values[count] = value;
    count++;
    if (count % fine.width() == 0) {
      build();
    }
  }

  private void build() {
    fine.put(count, values);
    if (count % coarse.width() == 0) {
      coarse.put(count, fine);
    }
    if (count == SIZE) {
      whole.put(count, coarse);
    }
  }

  long time(int index) {
    return times[index];
  }

  double value(int index) {
    return values[index];
  }

  /** The first index at or after a time; the count where there is none. */
  int indexOf(long time) {
    int low = 0;
    int high = count;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (times[middle] < time) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** Adds up the samples from one index to before another, from as few buckets as will do. */
  void summarize(int from, int to, Summary summary) {
    int at = from;
    while (at < to) {
      at = step(at, to, summary);
    }
  }

  private int step(int at, int to, Summary summary) {
    if (fits(at, to, whole)) {
      whole.into(0, summary);
      return to;
    }
    if (fits(at, to, coarse)) {
      coarse.into(at / coarse.width(), summary);
      return at + coarse.width();
    }
    if (fits(at, to, fine)) {
      fine.into(at / fine.width(), summary);
      return at + fine.width();
    }
    summary.add(values[at]);
    return at + 1;
  }

  private static boolean fits(int at, int to, Level level) {
    return at % level.width() == 0 && at + level.width() <= to;
  }
}
