package org.robotui.gl.internal.splat;

/**
 * Of each place of a mesh the sum of squared distances to planes (Garland and Heckbert's quadric error), weighted by
 * the areas for which the planes stand. Numbers of a place lie together.
 */
final class Quadrics {
  private static final int NUMBERS = 11;
  private static final int WEIGHT = 10;

  private final double[] sums;

  Quadrics(int places) {
    sums = new double[NUMBERS * places];
  }

  /**
   * Adds a plane.
   *
   * @param place of which
   * @param normal of unit length
   * @param offset of the plane: its points p have normal · p + offset = 0
   * @param weight square metres
   */
  void add(int place, double[] normal, double offset, double weight) {
    int at = NUMBERS * place;
    double x = normal[0] * weight;
    double y = normal[1] * weight;
    double z = normal[2] * weight;
    sums[at] += x * normal[0];
    sums[at + 1] += x * normal[1];
    sums[at + 2] += x * normal[2];
    sums[at + 3] += x * offset;
    sums[at + 4] += y * normal[1];
    sums[at + 5] += y * normal[2];
    sums[at + 6] += y * offset;
    sums[at + 7] += z * normal[2];
    sums[at + 8] += z * offset;
    sums[at + 9] += weight * offset * offset;
    sums[at + WEIGHT] += weight;
  }

  /** A place takes over the planes of another one. */
  void merge(int into, int from) {
    for (int i = 0; i < NUMBERS; i++) {
      sums[NUMBERS * into + i] += sums[NUMBERS * from + i];
    }
  }

  /** The mean distance (root of the mean square) of x, y, z from the planes of a place; metres. */
  double error(int place, double x, double y, double z) {
    int at = NUMBERS * place;
    double squares = sums[at] * x * x + sums[at + 4] * y * y + sums[at + 7] * z * z
        + 2 * (sums[at + 1] * x * y + sums[at + 2] * x * z + sums[at + 5] * y * z + sums[at + 3] * x + sums[at + 6] * y
            + sums[at + 8] * z)
        + sums[at + 9];
    return sums[at + WEIGHT] > 0 ? Math.sqrt(Math.max(0, squares) / sums[at + WEIGHT]) : 0;
  }
}
