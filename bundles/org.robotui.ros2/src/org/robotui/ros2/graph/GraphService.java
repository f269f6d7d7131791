package org.robotui.ros2.graph;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.ros2.name.Ros2Name;

/**
 * A service.
 *
 * @param name its whole name
 * @param servers the ends that take requests
 * @param clients the ends that send them
 */
public record GraphService(Ros2Name name, List<GraphEnd> servers, List<GraphEnd> clients) {

  /** Copies the lists. */
  public GraphService {
    servers = List.copyOf(servers);
    clients = List.copyOf(clients);
  }

  /**
   * The service's type, by its servers, or else by its clients.
   *
   * @return such as {@code std_srvs/srv/SetBool}
   */
  public Optional<TypeName> type() {
    return Stream.concat(servers.stream(), clients.stream())
        .flatMap(end -> end.type().flatMap(type -> type.whole("Request")).stream()).findFirst();
  }

  /**
   * The sum of the type of requests as servers announce it; that of the whole service nobody announces.
   *
   * @return empty if none does
   */
  public Optional<TypeHash> requestHash() {
    return servers.stream().flatMap(end -> end.hash().stream()).findFirst();
  }
}
