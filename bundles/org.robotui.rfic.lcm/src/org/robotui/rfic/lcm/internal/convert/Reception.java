package org.robotui.rfic.lcm.internal.convert;

import java.util.function.Consumer;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.TransformSet;

/**
 * What is known of a message beside its fields.
 *
 * @param robot whose frames its names mean
 * @param channel on which it came
 * @param stamp when it was measured, by the robot's clock as far as the message says
 * @param transforms takes what it says of frames
 */
public record Reception(String robot, String channel, Stamp stamp, Consumer<TransformSet> transforms) {
  FrameId frame(String name) {
    return new FrameId(robot, name);
  }

  /** Whose clock. */
  public ClockKind clock() {
    return stamp.clock();
  }
}
