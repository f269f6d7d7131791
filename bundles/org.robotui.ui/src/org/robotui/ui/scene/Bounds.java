package org.robotui.ui.scene;

/**
 * A rectangle along the axes, metres.
 *
 * @param minX left
 * @param minY lower
 * @param maxX right, not below left
 * @param maxY upper, not below lower
 */
public record Bounds(double minX, double minY, double maxX, double maxY) {
  /**
   * Checks the order.
   *
   * @param minX left
   * @param minY lower
   * @param maxX right
   * @param maxY upper
   */
  public Bounds {
    if (!(minX <= maxX && minY <= maxY)) {
      throw new IllegalArgumentException("no rectangle: x " + minX + " to " + maxX + ", y " + minY + " to " + maxY);
    }
  }

  /**
   * A square around a point.
   *
   * @param x its middle
   * @param y its middle
   * @param radius half its edge, not negative
   * @return the square
   */
  public static Bounds around(double x, double y, double radius) {
    return new Bounds(x - radius, y - radius, x + radius, y + radius);
  }

  /**
   * The smallest rectangle that holds both.
   *
   * @param other another rectangle
   * @return the union
   */
  public Bounds union(Bounds other) {
    return new Bounds(
        Math.min(minX, other.minX),
        Math.min(minY, other.minY),
        Math.max(maxX, other.maxX),
        Math.max(maxY, other.maxY));
  }

  /**
   * Tells whether a point lies within.
   *
   * @param x metres
   * @param y metres
   * @return true also on the edge
   */
  public boolean contains(double x, double y) {
    return x >= minX && x <= maxX && y >= minY && y <= maxY;
  }

  /**
   * The extent along x.
   *
   * @return metres
   */
  public double width() {
    return maxX - minX;
  }

  /**
   * The extent along y.
   *
   * @return metres
   */
  public double height() {
    return maxY - minY;
  }
}
