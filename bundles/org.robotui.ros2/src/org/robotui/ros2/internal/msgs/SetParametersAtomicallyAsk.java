package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * Sets all parameters or none ({@code rcl_interfaces/SetParametersAtomicallyRequest}).
 *
 * @param parameters with their new values
 */
@MessageType("rcl_interfaces/SetParametersAtomicallyRequest")
public record SetParametersAtomicallyAsk(List<WireParameter> parameters) {

  /** Copies the lists. */
  public SetParametersAtomicallyAsk {
    parameters = List.copyOf(parameters);
  }
}
