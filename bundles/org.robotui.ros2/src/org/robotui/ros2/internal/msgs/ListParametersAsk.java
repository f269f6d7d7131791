package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * Asks for names ({@code rcl_interfaces/ListParametersRequest}).
 *
 * @param prefixes what they begin with
 * @param depth how many parts, 0 for any
 */
@MessageType("rcl_interfaces/ListParametersRequest")
public record ListParametersAsk(List<String> prefixes, long depth) {

  /** Copies the lists. */
  public ListParametersAsk {
    prefixes = List.copyOf(prefixes);
  }
}
