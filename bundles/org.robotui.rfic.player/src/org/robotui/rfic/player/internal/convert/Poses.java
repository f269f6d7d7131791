package org.robotui.rfic.player.internal.convert;

import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Pose3d;

/** Places of Player as transforms, and back. */
public final class Poses {
  private static final double FARTHEST = 1e6;

  private Poses() {}

  public static RigidTransform of(Pose2d pose) {
    return new RigidTransform(finite(new Vector3(pose.x(), pose.y(), 0), "place"),
        Quaternion.fromYaw(finite(pose.yaw(), "yaw")));
  }

  public static RigidTransform of(Pose3d pose) {
    return new RigidTransform(finite(position(pose), "place"), Quaternion.fromRollPitchYaw(
        finite(pose.roll(), "roll"), finite(pose.pitch(), "pitch"), finite(pose.yaw(), "yaw")));
  }

  /** Where a device is mounted. Drivers leave parts of it unwritten: what cannot be such a place counts as 0. */
  public static RigidTransform mounted(Pose3d pose) {
    return new RigidTransform(new Vector3(sane(pose.x()), sane(pose.y()), sane(pose.z())),
        Quaternion.fromRollPitchYaw(sane(pose.roll()), sane(pose.pitch()), sane(pose.yaw())));
  }

  public static Pose2d planar(RigidTransform pose) {
    return new Pose2d(pose.translation().x(), pose.translation().y(), pose.rotation().yaw());
  }

  static Vector3 position(Pose3d pose) {
    return new Vector3(pose.x(), pose.y(), pose.z());
  }

  static Vector3 angles(Pose3d pose) {
    return new Vector3(pose.roll(), pose.pitch(), pose.yaw());
  }

  static Vector3 finite(Vector3 v, String what) {
    if (!v.isFinite()) {
      throw new IllegalArgumentException(what + ": must be finite, is " + v);
    }
    return v;
  }

  static double finite(double value, String what) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(what + ": must be finite, is " + value);
    }
    return value;
  }

  static double sane(double value) {
    return Math.abs(value) < FARTHEST ? value : 0; // false for what is no number, too
  }
}
