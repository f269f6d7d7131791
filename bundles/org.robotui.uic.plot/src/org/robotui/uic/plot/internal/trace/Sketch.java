package org.robotui.uic.plot.internal.trace;

import java.util.Arrays;

/**
 * The points of a line as a screen can show it; a value of NaN breaks it. Reused from paint to paint; one thread at a
 * time.
 */
public final class Sketch {
  private long[] times = new long[1024];
  private double[] values = new double[1024];
  private int size;
  private boolean dense;

  public void clear() {
    size = 0;
    dense = false;
  }

  public int size() {
    return size;
  }

  public long time(int index) {
    return times[index];
  }

  public double value(int index) {
    return values[index];
  }

  /** Whether there were more samples than columns. */
  public boolean isDense() {
    return dense;
  }

  void dense() {
    dense = true;
  }

  void add(long time, double value) {
    if (size == times.length) {
      times = Arrays.copyOf(times, 2 * size);
      values = Arrays.copyOf(values, 2 * size);
    }
    times[size] = time;
    values[size] = value;
    size++;
  }

  /** A column: its first sample, its extremes in the middle, its last sample. */
  void column(long firstTime, double first, long middle, Summary all, long lastTime, double last) {
    add(firstTime, first);
    if (all.count() > 1) {
      long between = Math.clamp(middle, firstTime, lastTime);
      boolean rising = !(first > last);
      add(between, rising ? all.min() : all.max());
      add(between, rising ? all.max() : all.min());
    }
    if (lastTime > firstTime || all.count() > 1) {
      add(lastTime, last);
    }
  }
}
