package org.robotui.entity.pointcloud.internal;

import org.robotui.data.sensor.PointCloud;

/**
 * The order in which points are copied: that of the cloud where all are, as memory is read many times faster so. Rows
 * of a sensor, thinned to every n-th point, make stripes; so where some are left out, a fixed step that has no divisor
 * in common with their number walks through all of them, about the golden ratio of the whole at a time: any beginning
 * of that order, and every n-th of it, is spread evenly over the cloud.
 *
 * @param total points of the cloud
 * @param count how many of them are taken
 * @param step from one to the next, modulo total
 * @param width points a row
 * @param pointStep bytes a point
 * @param rowStep bytes a row
 */
record Order(int total, int count, int step, int width, int pointStep, int rowStep) {
  private static final double GOLDEN = 0.6180339887498949;

  /** The order of a cloud, of which at most so many points are taken. */
  static Order of(PointCloud cloud, long most) {
    long all = (long) cloud.width() * cloud.height();
    // More than that are points of no bytes, or bytes that overlap: nothing a sensor sends.
    int total = (int) Math.min(all, CloudPoints.MOST * 4L);
    return new Order(total, (int) Math.min(total, most), total > most ? step(total) : 1, cloud.width(),
        cloud.pointStep(), cloud.rowStep());
  }

  /** Which point comes at a place of the order. */
  int source(int element) {
    return (int) ((long) element * step % total);
  }

  /** The one after a point. */
  int after(int source) {
    int next = source + step;
    return next < total ? next : next - total;
  }

  /** Where a point begins. */
  int offset(int source) {
    return contiguous() ? source * pointStep : source / width * rowStep + source % width * pointStep;
  }

  boolean contiguous() {
    return rowStep == width * pointStep;
  }

  /** From one to the next of so many, such that each comes once, and any beginning is spread evenly. */
  static int step(int total) {
    int step = Math.max(1, (int) (total * GOLDEN));
    while (divisor(step, total) > 1) {
      step++;
    }
    return step;
  }

  private static int divisor(int a, int b) {
    return b == 0 ? a : divisor(b, a % b);
  }
}
