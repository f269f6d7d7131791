package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * Descriptions ({@code rcl_interfaces/DescribeParametersResponse}).
 *
 * @param descriptors in the order of the names
 */
@MessageType("rcl_interfaces/DescribeParametersResponse")
public record DescribeParametersReply(List<WireDescriptor> descriptors) {

  /** Copies the lists. */
  public DescribeParametersReply {
    descriptors = List.copyOf(descriptors);
  }
}
