package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * Asks for descriptions ({@code rcl_interfaces/DescribeParametersRequest}).
 *
 * @param names of which parameters
 */
@MessageType("rcl_interfaces/DescribeParametersRequest")
public record DescribeParametersAsk(List<String> names) {

  /** Copies the lists. */
  public DescribeParametersAsk {
    names = List.copyOf(names);
  }
}
