package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * How far all goals of an action got ({@code action_msgs/GoalStatusArray}).
 *
 * @param statusList those the server remembers
 */
@MessageType("action_msgs/GoalStatusArray")
public record WireGoalStatusArray(List<WireGoalStatus> statusList) {

  /** Copies the lists. */
  public WireGoalStatusArray {
    statusList = List.copyOf(statusList);
  }
}
