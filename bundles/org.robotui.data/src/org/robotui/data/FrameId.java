package org.robotui.data;

import org.robotui.data.internal.Check;

/**
 * A coordinate frame of one robot. Two robots' {@code base_link} are different frames.
 *
 * @param robot the robot's name in the configuration
 * @param name the frame's name there, without a leading slash; empty where the robot names none
 */
public record FrameId(String robot, String name) {
  /**
   * Checks and normalises: a leading slash (old tf) is taken away.
   *
   * @param robot the robot's name
   * @param name the frame's name
   */
  public FrameId {
    Check.that(!robot.isBlank(), "robot", "a frame belongs to a robot");
    name = name.startsWith("/") ? name.substring(1) : name;
  }

  /**
   * Whether the robot gave it a name.
   *
   * @return false where the name is empty
   */
  public boolean isNamed() {
    return !name.isEmpty();
  }

  @Override
  public String toString() {
    return robot + ":" + name;
  }
}
