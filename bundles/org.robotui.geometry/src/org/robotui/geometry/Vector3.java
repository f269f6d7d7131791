package org.robotui.geometry;

/**
 * A vector or a point in three dimensions.
 *
 * @param x first coordinate, metres where it is a position
 * @param y second coordinate
 * @param z third coordinate
 */
public record Vector3(double x, double y, double z) {
  /** The origin. */
  public static final Vector3 ZERO = new Vector3(0, 0, 0);

  /**
   * Adds.
   *
   * @param other the vector to add
   * @return the sum
   */
  public Vector3 plus(Vector3 other) {
    return new Vector3(x + other.x, y + other.y, z + other.z);
  }

  /**
   * Subtracts.
   *
   * @param other the vector to take away
   * @return the difference
   */
  public Vector3 minus(Vector3 other) {
    return new Vector3(x - other.x, y - other.y, z - other.z);
  }

  /**
   * Scales.
   *
   * @param factor the factor
   * @return the scaled vector
   */
  public Vector3 times(double factor) {
    return new Vector3(x * factor, y * factor, z * factor);
  }

  /**
   * The inner product.
   *
   * @param other the other vector
   * @return the inner product
   */
  public double dot(Vector3 other) {
    return x * other.x + y * other.y + z * other.z;
  }

  /**
   * The cross product.
   *
   * @param other the other vector
   * @return a vector normal to both
   */
  public Vector3 cross(Vector3 other) {
    return new Vector3(y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
  }

  /**
   * The Euclidean length.
   *
   * @return the length, never negative
   */
  public double norm() {
    return Math.sqrt(dot(this));
  }

  /**
   * Tells whether all coordinates are finite numbers.
   *
   * @return false where one is NaN or infinite
   */
  public boolean isFinite() {
    return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
  }
}
