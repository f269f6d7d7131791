package org.robotui.message.data;

import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.Transform;

/** Geometry of ROS messages. A quaternion of all zeros, which ROS nodes send for "none", is read as no rotation. */
final class Geometry {
  private Geometry() {}

  static RigidTransform transform(Pose pose) {
    return new RigidTransform(point(pose.position()), rotation(pose.orientation()));
  }

  static RigidTransform transform(Transform transform) {
    return new RigidTransform(translation(transform.translation()), rotation(transform.rotation()));
  }

  static Vector3 point(Point p) {
    return finite(new Vector3(p.x(), p.y(), p.z()), "position");
  }

  private static Vector3 translation(org.robotui.message.ros.geometry_msgs.Vector3 v) {
    return finite(new Vector3(v.x(), v.y(), v.z()), "translation");
  }

  static Vector3 vector(org.robotui.message.ros.geometry_msgs.Vector3 v) {
    return finite(new Vector3(v.x(), v.y(), v.z()), "vector");
  }

  static Quaternion rotation(org.robotui.message.ros.geometry_msgs.Quaternion q) {
    boolean none = q.x() == 0 && q.y() == 0 && q.z() == 0 && q.w() == 0;
    return none ? Quaternion.IDENTITY : normalized(new Quaternion(q.x(), q.y(), q.z(), q.w()));
  }

  static Pose pose(RigidTransform transform) {
    Vector3 t = transform.translation();
    Quaternion q = transform.rotation();
    return new Pose(
        new Point(t.x(), t.y(), t.z()),
        new org.robotui.message.ros.geometry_msgs.Quaternion(q.x(), q.y(), q.z(), q.w()));
  }

  static org.robotui.message.ros.geometry_msgs.Vector3 vector(Vector3 v) {
    return new org.robotui.message.ros.geometry_msgs.Vector3(v.x(), v.y(), v.z());
  }

  private static Quaternion normalized(Quaternion q) {
    try {
      return q.normalized();
    } catch (ArithmeticException e) {
      throw new IllegalArgumentException("orientation: " + e.getMessage(), e);
    }
  }

  private static Vector3 finite(Vector3 v, String what) {
    if (!v.isFinite()) {
      throw new IllegalArgumentException(what + ": must be finite, is " + v);
    }
    return v;
  }
}
