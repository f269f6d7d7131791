package org.robotui.ros2.graph;

import java.util.List;
import java.util.Optional;
import org.robotui.message.description.TypeName;
import org.robotui.ros2.name.Ros2Name;

/**
 * An action.
 *
 * @param name its whole name
 * @param type its type, such as {@code nav2_msgs/action/NavigateToPose}; empty if no end tells it
 * @param servers the ends that take goals
 * @param clients the ends that send them
 */
public record GraphAction(Ros2Name name, Optional<TypeName> type, List<GraphEnd> servers, List<GraphEnd> clients) {

  /** Copies the lists. */
  public GraphAction {
    servers = List.copyOf(servers);
    clients = List.copyOf(clients);
  }
}
