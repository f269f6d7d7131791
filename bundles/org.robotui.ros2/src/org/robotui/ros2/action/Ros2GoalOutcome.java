package org.robotui.ros2.action;

import java.util.Objects;
import java.util.Optional;
import org.robotui.message.DynamicMessage;

/**
 * What became of a goal.
 *
 * @param end how it ended
 * @param text why it is lost or was rejected, or why its result cannot be read; else empty, as servers of ROS 2 have no
 * words of their own
 * @param result the result; empty if none came
 */
public record Ros2GoalOutcome(Ros2GoalEnd end, String text, Optional<DynamicMessage> result) {

  /** Checks that nothing is missing. */
  public Ros2GoalOutcome {
    Objects.requireNonNull(end, "end");
    Objects.requireNonNull(text, "text");
    Objects.requireNonNull(result, "result");
  }
}
