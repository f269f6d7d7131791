package org.robotui.data;

import java.util.List;

/**
 * The bumpers of a robot, all at one time.
 *
 * @param frame of their poses, mostly the robot's base
 * @param bumpers in the order in which the robot counts them
 */
public record Bumpers(FrameId frame, List<Bumper> bumpers) implements Data, InFrame {
  /**
   * Copies the list.
   *
   * @param frame of their poses
   * @param bumpers in the order in which the robot counts them
   */
  public Bumpers {
    bumpers = List.copyOf(bumpers);
  }

  /**
   * How many are pressed.
   *
   * @return 0 where nothing touches the robot
   */
  public int pressed() {
    return (int) bumpers.stream().filter(Bumper::pressed).count();
  }
}
