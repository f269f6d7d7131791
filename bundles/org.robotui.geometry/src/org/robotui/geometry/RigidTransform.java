package org.robotui.geometry;

/**
 * A rotation followed by a translation: {@code p_target = rotation * p_source + translation}.
 *
 * @param translation origin of the source frame in the target frame, metres
 * @param rotation orientation of the source frame in the target frame, unit length
 */
public record RigidTransform(Vector3 translation, Quaternion rotation) {
  /** The transform that changes nothing. */
  public static final RigidTransform IDENTITY = new RigidTransform(Vector3.ZERO, Quaternion.IDENTITY);

  /**
   * A transform in the plane.
   *
   * @param x metres
   * @param y metres
   * @param yaw radians
   * @return the transform
   */
  public static RigidTransform planar(double x, double y, double yaw) {
    return new RigidTransform(new Vector3(x, y, 0), Quaternion.fromYaw(yaw));
  }

  /**
   * Composes: {@code aFromB.times(bFromC)} is {@code aFromC}.
   *
   * @param other the transform applied first
   * @return the product
   */
  public RigidTransform times(RigidTransform other) {
    return new RigidTransform(apply(other.translation), rotation.times(other.rotation));
  }

  /**
   * The opposite transform.
   *
   * @return source from target
   */
  public RigidTransform inverse() {
    Quaternion back = rotation.inverse();
    return new RigidTransform(back.rotate(translation).times(-1), back);
  }

  /**
   * Transforms a point.
   *
   * @param point in the source frame
   * @return the same point in the target frame
   */
  public Vector3 apply(Vector3 point) {
    return rotation.rotate(point).plus(translation);
  }

  /**
   * Interpolates: the translation linearly, the rotation along the shorter arc.
   *
   * @param other the transform at {@code t = 1}
   * @param t from 0 to 1
   * @return the transform in between
   */
  public RigidTransform interpolate(RigidTransform other, double t) {
    Vector3 moved = translation.plus(other.translation.minus(translation).times(t));
    return new RigidTransform(moved, rotation.slerp(other.rotation, t));
  }
}
