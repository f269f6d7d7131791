package org.robotui.sim.internal.player;

import org.robotui.player.interfaces.Body;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Pose3d;
import org.robotui.player.interfaces.Size3d;
import org.robotui.sim.internal.world.Pose2;

/** Places, as Player writes them. */
final class Poses {
  private Poses() {}

  static Pose2d of(Pose2 pose) {
    return new Pose2d(pose.x(), pose.y(), pose.yaw());
  }

  static Pose2 planar(Pose2d pose) {
    return new Pose2(pose.x(), pose.y(), pose.yaw());
  }

  static boolean isFinite(Pose2d pose) {
    return Double.isFinite(pose.x()) && Double.isFinite(pose.y()) && Double.isFinite(pose.yaw());
  }

  static Pose3d mount(Pose2 pose, double height) {
    return new Pose3d(pose.x(), pose.y(), height, 0, 0, pose.yaw());
  }

  static Pose3d ahead(double forward, double height) {
    return mount(new Pose2(forward, 0, 0), height);
  }

  /** @param diameter metres */
  static Body round(Pose3d pose, double diameter, double height) {
    return new Body(pose, new Size3d(diameter, diameter, height));
  }
}
