package org.robotui.message.data;

import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;

/**
 * Names frames and times of one robot.
 *
 * @param robot the robot's name
 * @param clock whose clock its stamps are read from
 */
public record FrameNames(String robot, ClockKind clock) {
  /**
   * Names a frame of the robot.
   *
   * @param name as the robot's messages have it
   * @return the frame
   */
  public FrameId frame(String name) {
    return new FrameId(robot, name);
  }

  /**
   * Says whose clock a time was read from.
   *
   * @param nanos since the epoch of that clock
   * @return the stamp
   */
  public Stamp stamp(long nanos) {
    return new Stamp(nanos, clock);
  }
}
