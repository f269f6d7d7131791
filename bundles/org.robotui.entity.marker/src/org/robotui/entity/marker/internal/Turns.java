package org.robotui.entity.marker.internal;

import org.robotui.geometry.Quaternion;
import org.robotui.geometry.Vector3;

/** Rotations. */
final class Turns {
  private Turns() {}

  /** The shortest rotation that brings one direction onto another, both of unit length. */
  static Quaternion between(Vector3 from, Vector3 to) {
    Vector3 axis = from.cross(to);
    double w = 1 + from.dot(to);
    if (w < 1e-9) {
      Vector3 side = Math.abs(from.x()) < 0.9 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
      Vector3 normal = from.cross(side);
      return new Quaternion(normal.x(), normal.y(), normal.z(), 0).normalized();
    }
    return new Quaternion(axis.x(), axis.y(), axis.z(), w).normalized();
  }

  /** A rotation by an angle about an axis of unit length. */
  static Quaternion about(Vector3 axis, double angle) {
    double s = Math.sin(angle / 2);
    return new Quaternion(axis.x() * s, axis.y() * s, axis.z() * s, Math.cos(angle / 2));
  }
}
