package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * The changes ({@code lifecycle_msgs/GetAvailableTransitionsResponse}).
 *
 * @param availableTransitions now
 */
@MessageType("lifecycle_msgs/GetAvailableTransitionsResponse")
public record GetAvailableTransitionsReply(List<WireTransitionDescription> availableTransitions) {

  /** Copies the lists. */
  public GetAvailableTransitionsReply {
    availableTransitions = List.copyOf(availableTransitions);
  }
}
