package org.robotui.geometry;

/**
 * A rotation as a quaternion. The operations assume unit length; {@link #normalized()} makes it so.
 *
 * @param x imaginary part along x
 * @param y imaginary part along y
 * @param z imaginary part along z
 * @param w real part
 */
public record Quaternion(double x, double y, double z, double w) {
  /** No rotation. */
  public static final Quaternion IDENTITY = new Quaternion(0, 0, 0, 1);

  private static final double NEARLY_PARALLEL = 1 - 1e-9;

  /**
   * A rotation about the z axis.
   *
   * @param yaw angle in radians, counter-clockwise seen from above
   * @return the rotation
   */
  public static Quaternion fromYaw(double yaw) {
    return new Quaternion(0, 0, Math.sin(yaw / 2), Math.cos(yaw / 2));
  }

  /**
   * A rotation from fixed-axis angles as in REP-103: about x, then y, then z of the fixed frame.
   *
   * @param roll angle about x, radians
   * @param pitch angle about y, radians
   * @param yaw angle about z, radians
   * @return the rotation
   */
  public static Quaternion fromRollPitchYaw(double roll, double pitch, double yaw) {
    Quaternion aboutX = new Quaternion(Math.sin(roll / 2), 0, 0, Math.cos(roll / 2));
    Quaternion aboutY = new Quaternion(0, Math.sin(pitch / 2), 0, Math.cos(pitch / 2));
    return fromYaw(yaw).times(aboutY).times(aboutX);
  }

  /**
   * The heading: the angle of the rotated x axis in the x-y plane.
   *
   * @return radians in [-pi, pi]
   */
  public double yaw() {
    return Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
  }

  /**
   * The angle about the fixed y axis.
   *
   * @return radians in [-pi/2, pi/2]
   */
  public double pitch() {
    return Math.asin(Math.clamp(2 * (w * y - z * x), -1.0, 1.0));
  }

  /**
   * The angle about the fixed x axis.
   *
   * @return radians in [-pi, pi]
   */
  public double roll() {
    return Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y));
  }

  /**
   * Composes: first {@code other}, then this.
   *
   * @param other the rotation applied first
   * @return the product
   */
  public Quaternion times(Quaternion other) {
    return new Quaternion(
        w * other.x + x * other.w + y * other.z - z * other.y,
        w * other.y - x * other.z + y * other.w + z * other.x,
        w * other.z + x * other.y - y * other.x + z * other.w,
        w * other.w - x * other.x - y * other.y - z * other.z);
  }

  /**
   * The opposite rotation.
   *
   * @return the conjugate
   */
  public Quaternion inverse() {
    return new Quaternion(-x, -y, -z, w);
  }

  /**
   * Rotates a vector.
   *
   * @param v the vector
   * @return the rotated vector
   */
  public Vector3 rotate(Vector3 v) {
    Vector3 axis = new Vector3(x, y, z);
    Vector3 t = axis.cross(v).times(2);
    return v.plus(t.times(w)).plus(axis.cross(t));
  }

  /**
   * The length of the four numbers; 1 for a rotation.
   *
   * @return the length
   */
  public double norm() {
    return Math.sqrt(x * x + y * y + z * z + w * w);
  }

  /**
   * Scales to unit length.
   *
   * @return the same rotation with unit length
   * @throws ArithmeticException where the length is zero or not finite: then it is no rotation
   */
  public Quaternion normalized() {
    double n = norm();
    if (!(n > 0) || !Double.isFinite(n)) {
      throw new ArithmeticException("no rotation: the quaternion " + this + " has length " + n);
    }
    return new Quaternion(x / n, y / n, z / n, w / n);
  }

  /**
   * Interpolates along the shorter arc at constant angular speed.
   *
   * @param other the rotation at {@code t = 1}
   * @param t from 0 to 1
   * @return the rotation in between
   */
  public Quaternion slerp(Quaternion other, double t) {
    double cos = x * other.x + y * other.y + z * other.z + w * other.w;
    double sign = cos < 0 ? -1 : 1;
    double angle = Math.acos(Math.min(1, cos * sign));
    boolean parallel = cos * sign > NEARLY_PARALLEL;
    double a = parallel ? 1 - t : Math.sin((1 - t) * angle) / Math.sin(angle);
    double b = sign * (parallel ? t : Math.sin(t * angle) / Math.sin(angle));
    return new Quaternion(a * x + b * other.x, a * y + b * other.y, a * z + b * other.z, a * w + b * other.w)
        .normalized();
  }
}
