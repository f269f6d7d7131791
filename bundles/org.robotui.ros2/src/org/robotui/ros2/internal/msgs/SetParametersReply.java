package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * What was set ({@code rcl_interfaces/SetParametersResponse}).
 *
 * @param results in the order of the parameters
 */
@MessageType("rcl_interfaces/SetParametersResponse")
public record SetParametersReply(List<WireSetResult> results) {

  /** Copies the lists. */
  public SetParametersReply {
    results = List.copyOf(results);
  }
}
