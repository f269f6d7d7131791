package org.robotui.entity.odometry;

import java.util.Arrays;

/**
 * Where something has been: positions at least a little apart, of bounded number. When it is full, every second position
 * goes and the least distance doubles, so that a long way stays whole. Not safe for several threads.
 */
final class Trail {
  private static final double FINEST = 0.02;

  private final int capacity;
  private final double[] xy;
  private int count;
  private double apart = FINEST;

  Trail(int capacity) {
    this.capacity = capacity;
    this.xy = new double[2 * capacity];
  }

  void add(double x, double y) {
    if (!Double.isFinite(x) || !Double.isFinite(y) || count > 0 && near(x, y)) {
      return;
    }
    if (count == capacity) {
      thin();
    }
    xy[2 * count] = x;
    xy[2 * count + 1] = y;
    count++;
  }

  /** Forgets the oldest part beyond a length, metres. */
  void cut(double length) {
    double kept = 0;
    int first = count - 1;
    while (first > 0 && kept < length) {
      kept += Math.hypot(xy[2 * first] - xy[2 * first - 2], xy[2 * first + 1] - xy[2 * first - 1]);
      first--;
    }
    if (first > 0) {
      System.arraycopy(xy, 2 * first, xy, 0, 2 * (count - first));
      count -= first;
    }
  }

  void clear() {
    count = 0;
    apart = FINEST;
  }

  int count() {
    return count;
  }

  /** A copy: x and y in turn. */
  double[] points() {
    return Arrays.copyOf(xy, 2 * count);
  }

  private boolean near(double x, double y) {
    return Math.hypot(x - xy[2 * count - 2], y - xy[2 * count - 1]) < apart;
  }

  private void thin() {
    int kept = 0;
    for (int i = 0; i < count; i += 2) {
      xy[2 * kept] = xy[2 * i];
      xy[2 * kept + 1] = xy[2 * i + 1];
      kept++;
    }
    count = kept;
    apart *= 2;
  }
}
