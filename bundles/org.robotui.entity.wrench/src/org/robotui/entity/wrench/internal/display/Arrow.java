package org.robotui.entity.wrench.internal.display;

import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * How a vector is drawn.
 *
 * @param turn from the x axis to its direction
 * @param length metres
 * @param cut whether it would be longer
 */
record Arrow(RigidTransform turn, double length, boolean cut) {
  private static final double LEAST = 1e-6;

  static Arrow of(Vector3 vector, double scale, double longest) {
    double wanted = vector.norm() * scale;
    double yaw = Math.atan2(vector.y(), vector.x());
    double pitch = Math.atan2(-vector.z(), Math.hypot(vector.x(), vector.y()));
    return new Arrow(new RigidTransform(Vector3.ZERO, Quaternion.fromRollPitchYaw(0, pitch, yaw)),
        Math.min(wanted, longest), wanted > longest);
  }

  /** Whether there is anything to see. */
  boolean seen() {
    return length > LEAST;
  }
}
