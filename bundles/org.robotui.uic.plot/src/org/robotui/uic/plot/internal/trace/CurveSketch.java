package org.robotui.uic.plot.internal.trace;

import java.util.Arrays;

/** The points of a curve as a screen can show it; NaN breaks it. Reused from paint to paint; one thread at a time. */
public final class CurveSketch {
  /** A rough curve is divided into so many runs of samples, up to twice as many; each has at most five points. */
  static final int MOST_RUNS = 4096;

  private long[] times = new long[1024];
  private double[] xs = new double[1024];
  private double[] ys = new double[1024];
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

  public double x(int index) {
    return xs[index];
  }

  public double y(int index) {
    return ys[index];
  }

  /** Whether there were more points than can be drawn. */
  public boolean isDense() {
    return dense;
  }

  void dense() {
    dense = true;
  }

  void add(long time, double x, double y) {
    if (size == times.length) {
      times = Arrays.copyOf(times, 2 * size);
      xs = Arrays.copyOf(xs, 2 * size);
      ys = Arrays.copyOf(ys, 2 * size);
    }
    times[size] = time;
    xs[size] = x;
    ys[size] = y;
    size++;
  }
}
