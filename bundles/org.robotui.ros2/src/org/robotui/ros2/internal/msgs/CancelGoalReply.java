package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * What is cancelled ({@code action_msgs/CancelGoalResponse}).
 *
 * @param returnCode 0, or why nothing is
 * @param goalsCanceling the goals
 */
@MessageType("action_msgs/CancelGoalResponse")
public record CancelGoalReply(int returnCode, List<WireGoalInfo> goalsCanceling) {

  /** Copies the lists. */
  public CancelGoalReply {
    goalsCanceling = List.copyOf(goalsCanceling);
  }
}
