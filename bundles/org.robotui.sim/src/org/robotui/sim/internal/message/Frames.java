package org.robotui.sim.internal.message;

/** Names of the coordinate frames. Robots with a namespace share the map, and keep the rest to themselves. */
public final class Frames {
  public static final String MAP = "map";
  private final String prefix;

  /** @param namespace such as {@code keira} or {@code team/keira}; empty for none */
  public Frames(String namespace) {
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

  /** The spinning scanner. */
  String lidar() {
    return prefix + "base_lidar";
  }

  String imu() {
    return prefix + "imu_link";
  }

  String satellites() {
    return prefix + "gps_link";
  }

  /** The turning part of the head. */
  String pan() {
    return prefix + "pan_link";
  }

  /** The nodding part of the head. */
  String tilt() {
    return prefix + "tilt_link";
  }

  String camera() {
    return prefix + "camera_link";
  }

  /** Looks along its z axis, with x to the right. */
  String cameraOptical() {
    return prefix + "camera_optical";
  }

  String sonar(int index) {
    return sonars() + index;
  }

  /** What the names of all sonars begin with. */
  String sonars() {
    return prefix + "sonar_";
  }

  String leftWheel() {
    return prefix + "left_wheel_link";
  }

  String rightWheel() {
    return prefix + "right_wheel_link";
  }
}
