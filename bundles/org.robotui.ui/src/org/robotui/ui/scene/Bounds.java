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
   * The smallest rectangle that holds points.
   *
   * @param xy x and y in turn, of one point at least
   * @return the rectangle
   */
  public static Bounds of(double[] xy) {
    double minX = xy[0];
    double minY = xy[1];
    double maxX = minX;
    double maxY = minY;
    for (int i = 2; i < xy.length; i += 2) {
      minX = Math.min(minX, xy[i]);
      maxX = Math.max(maxX, xy[i]);
      minY = Math.min(minY, xy[i + 1]);
      maxY = Math.max(maxY, xy[i + 1]);
    }
    return new Bounds(minX, minY, maxX, maxY);
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
   * Tells whether they have a point in common.
   *
   * @param other another rectangle
   * @return true also where only edges touch
   */
  public boolean intersects(Bounds other) {
    return minX <= other.maxX && other.minX <= maxX && minY <= other.maxY && other.minY <= maxY;
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
