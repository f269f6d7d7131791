package org.robotui.uic.plot.internal.view;

import java.util.Arrays;

/**
 * The points of an unbroken line on the screen. Points without which it looks the same are left out, since each costs
 * time: what is left lies nowhere further than {@value #FAITHFUL} points above or below the line through all. Reused;
 * one thread at a time.
 */
final class LineShape {
  static final float FAITHFUL = 0.3f;

  private float[] xs = new float[4096];
  private float[] ys = new float[4096];
  private int size;
  private boolean waits;
  private float waitingX;
  private float waitingY;
  private double lowest;
  private double highest;
  private float lastY;
  private double climb;

  void clear() {
    size = 0;
    waits = false;
    climb = 0;
  }

  /** Adds a point; x never falls. */
  void add(float x, float y) {
    climb += size > 0 ? Math.abs(y - lastY) : 0;
    lastY = y;
    if (size == 0) {
      put(x, y);
      return;
    }
    if (waits && !onTheWay(x, y)) {
      put(waitingX, waitingY);
      waits = false;
    }
    if (!waits) {
      lowest = Double.NEGATIVE_INFINITY;
      highest = Double.POSITIVE_INFINITY;
    }
    double run = x - xs[size - 1];
    if (run > 0) {
      lowest = Math.max(lowest, (y - FAITHFUL - ys[size - 1]) / run);
      highest = Math.min(highest, (y + FAITHFUL - ys[size - 1]) / run);
      waits = true;
      waitingX = x;
      waitingY = y;
    } else {
      put(x, y);
    }
  }

  /** Ends the line. */
  void end() {
    if (waits) {
      put(waitingX, waitingY);
      waits = false;
    }
  }

  int size() {
    return size;
  }

  float x(int index) {
    return xs[index];
  }

  float y(int index) {
    return ys[index];
  }

  /** How far it goes up and down in all, points. */
  double climb() {
    return climb;
  }

  /** Whether a straight line to that point passes all that was left out since the last one kept. */
  private boolean onTheWay(float x, float y) {
    double run = x - xs[size - 1];
    if (run <= 0) {
      return false;
    }
    double slope = (y - ys[size - 1]) / run;
    return slope >= lowest && slope <= highest;
  }

  private void put(float x, float y) {
    if (size == xs.length) {
      xs = Arrays.copyOf(xs, 2 * size);
      ys = Arrays.copyOf(ys, 2 * size);
    }
    xs[size] = x;
    ys[size] = y;
    size++;
  }
}
