package org.robotui.api.session;

import org.robotui.data.FrameId;

/**
 * Names the frames of one robot.
 *
 * @param robot the robot's name
 * @param names of those that carry all others
 */
public record RobotFrames(String robot, BaseFrames names) {
  /**
   * The frame of its base.
   *
   * @return x forward, y left, z up
   */
  public FrameId base() {
    return new FrameId(robot, names.base());
  }

  /**
   * The frame in which its odometry is told.
   *
   * @return the frame
   */
  public FrameId odom() {
    return new FrameId(robot, names.odom());
  }

  /**
   * The frame of maps, plans and localisation.
   *
   * @return the frame
   */
  public FrameId map() {
    return new FrameId(robot, names.map());
  }

  /**
   * The frame of something on it.
   *
   * @param name how the framework calls it
   * @return the frame
   */
  public FrameId device(String name) {
    return new FrameId(robot, name);
  }
}
