package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * Names of parameters ({@code rcl_interfaces/ListParametersResult}).
 *
 * @param names whole names
 * @param prefixes what they begin with
 */
@MessageType("rcl_interfaces/ListParametersResult")
public record WireListResult(List<String> names, List<String> prefixes) {

  /** Copies the lists. */
  public WireListResult {
    names = List.copyOf(names);
    prefixes = List.copyOf(prefixes);
  }
}
