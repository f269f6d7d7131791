package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * Values ({@code rcl_interfaces/GetParametersResponse}).
 *
 * @param values in the order of the names
 */
@MessageType("rcl_interfaces/GetParametersResponse")
public record GetParametersReply(List<WireValue> values) {

  /** Copies the lists. */
  public GetParametersReply {
    values = List.copyOf(values);
  }
}
