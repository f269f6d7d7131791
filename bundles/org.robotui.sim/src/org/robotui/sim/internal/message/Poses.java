package org.robotui.sim.internal.message;

import org.robotui.geometry.RigidTransform;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.sim.internal.world.Pose2;

/** Between the plane of the simulation and the space of the messages. */
public final class Poses {
  private Poses() {}

  public static Pose pose(Pose2 pose) {
    return new Pose(new Point(pose.x(), pose.y(), 0), yaw(pose.yaw()));
  }

  static Quaternion yaw(double yaw) {
    return quaternion(org.robotui.geometry.Quaternion.fromYaw(yaw));
  }

  private static Quaternion quaternion(org.robotui.geometry.Quaternion q) {
    return new Quaternion(q.x(), q.y(), q.z(), q.w());
  }

  static RigidTransform transform(Pose2 pose, double height) {
    return new RigidTransform(
        new org.robotui.geometry.Vector3(pose.x(), pose.y(), height),
        org.robotui.geometry.Quaternion.fromYaw(pose.yaw()));
  }

  static TransformStamped stamped(Header parent, String child, RigidTransform transform) {
    org.robotui.geometry.Vector3 t = transform.translation();
    return new TransformStamped(
        parent, child, new Transform(new Vector3(t.x(), t.y(), t.z()), quaternion(transform.rotation())));
  }

  /** The planar part of a pose; a quaternion that is far from unit length counts as no rotation. */
  static Pose2 planar(Pose pose) {
    Quaternion q = pose.orientation();
    var rotation = new org.robotui.geometry.Quaternion(q.x(), q.y(), q.z(), q.w());
    boolean usable = rotation.norm() > 0.5 && rotation.norm() < 2;
    double yaw = usable ? rotation.normalized().yaw() : 0;
    return new Pose2(pose.position().x(), pose.position().y(), yaw);
  }

  static boolean isFinite(Pose pose) {
    Quaternion q = pose.orientation();
    return Double.isFinite(pose.position().x() + pose.position().y() + q.x() + q.y() + q.z() + q.w());
  }
}
