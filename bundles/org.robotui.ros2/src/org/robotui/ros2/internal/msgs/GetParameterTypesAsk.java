package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * Asks for types ({@code rcl_interfaces/GetParameterTypesRequest}).
 *
 * @param names of which parameters
 */
@MessageType("rcl_interfaces/GetParameterTypesRequest")
public record GetParameterTypesAsk(List<String> names) {

  /** Copies the lists. */
  public GetParameterTypesAsk {
    names = List.copyOf(names);
  }
}
