package org.robotui.rfic.ros.internal.convert;

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
  FrameId frame(String name) {
    return new FrameId(robot, name);
  }

  Stamp stamp(long nanos) {
    return new Stamp(nanos, clock);
  }
}
