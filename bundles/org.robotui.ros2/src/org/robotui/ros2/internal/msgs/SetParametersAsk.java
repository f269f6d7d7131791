package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * Sets parameters ({@code rcl_interfaces/SetParametersRequest}).
 *
 * @param parameters with their new values
 */
@MessageType("rcl_interfaces/SetParametersRequest")
public record SetParametersAsk(List<WireParameter> parameters) {

  /** Copies the lists. */
  public SetParametersAsk {
    parameters = List.copyOf(parameters);
  }
}
