package org.robotui.rfic.player.internal.convert;

import org.robotui.data.FrameId;

/**
 * Names the frames of one robot. Player knows no names of frames: a device's own frame is called after the device.
 *
 * @param robot the robot's name
 * @param names those that the configuration gives
 */
public record FrameNames(String robot, Names names) {
  /**
   * The frames that carry all others.
   *
   * @param base of the robot's base
   * @param odom in which odometry says where the base is
   * @param map of maps, plans and localisation
   */
  public record Names(String base, String odom, String map) {}

  public FrameId base() {
    return new FrameId(robot, names.base());
  }

  public FrameId odom() {
    return new FrameId(robot, names.odom());
  }

  public FrameId map() {
    return new FrameId(robot, names.map());
  }

  /** The frame of a device, such as {@code laser_0} of {@code laser:0}. */
  public FrameId device(String name) {
    return new FrameId(robot, name.replace(':', '_'));
  }

  /** The frame of one sensor of a device. */
  public FrameId element(String name, int index) {
    return new FrameId(robot, name.replace(':', '_') + "_" + index);
  }
}
