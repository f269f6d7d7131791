package org.robotui.sim.internal.ros;

/** Names of the coordinate frames. Robots with a namespace share the map, and keep the rest to themselves. */
final class Frames {
  static final String MAP = "map";
  private final String prefix;

  /** @param namespace such as {@code keira} or {@code team/keira}; empty for none */
  Frames(String namespace) {
    prefix = namespace.isEmpty() ? "" : namespace + "/";
  }

  String odometry() {
    return prefix + "odom";
  }

  String base() {
    return prefix + "base_link";
  }

  String laser() {
    return prefix + "laser";
  }

  String imu() {
    return prefix + "imu_link";
  }

  String camera() {
    return prefix + "camera_link";
  }

  /** Looks along its z axis, with x to the right. */
  String cameraOptical() {
    return prefix + "camera_optical";
  }

  String sonar(int index) {
    return prefix + "sonar_" + index;
  }
}
