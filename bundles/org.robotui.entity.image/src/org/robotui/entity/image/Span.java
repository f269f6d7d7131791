package org.robotui.entity.image;

/**
 * A range of numbers.
 *
 * @param low the smallest
 * @param high the largest, above the smallest
 */
public record Span(double low, double high) {
  /**
   * Checks the order.
   *
   * @param low the smallest
   * @param high the largest
   */
  public Span {
    if (!(low < high) || !Double.isFinite(high - low)) {
      throw new IllegalArgumentException("no range: " + low + " to " + high);
    }
  }

  /**
   * Where a number lies.
   *
   * @param value the number
   * @return 0 at the low end, 1 at the high end; beyond them less or more
   */
  public double share(double value) {
    return (value - low) / (high - low);
  }
}
