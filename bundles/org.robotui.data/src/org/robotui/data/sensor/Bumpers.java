package org.robotui.data.sensor;

import java.util.List;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;

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
