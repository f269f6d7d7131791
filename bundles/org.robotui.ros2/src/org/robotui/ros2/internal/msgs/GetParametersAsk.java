package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * Asks for values ({@code rcl_interfaces/GetParametersRequest}).
 *
 * @param names of which parameters
 */
@MessageType("rcl_interfaces/GetParametersRequest")
public record GetParametersAsk(List<String> names) {

  /** Copies the lists. */
  public GetParametersAsk {
    names = List.copyOf(names);
  }
}
