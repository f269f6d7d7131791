package org.robotui.ros2.internal.graph;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Endpoint;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.Guid;

/** The nodes of this context with their ends. Safe for several threads. */
final class OwnEnds {

  private final Map<Ros2Name, List<Endpoint>> nodes = new LinkedHashMap<>();

  synchronized boolean addNode(Ros2Name name) {
    return nodes.putIfAbsent(name, new ArrayList<>()) == null;
  }

  synchronized void removeNode(Ros2Name name) {
    nodes.remove(name);
  }

  synchronized void add(Ros2Name node, Endpoint end) {
    List<Endpoint> ends = nodes.get(node);
    if (ends != null) {
      ends.add(end);
    }
  }

  synchronized void remove(Ros2Name node, Endpoint end) {
    List<Endpoint> ends = nodes.get(node);
    if (ends != null) {
      ends.remove(end);
    }
  }

  synchronized List<Ros2Name> names() {
    return List.copyOf(nodes.keySet());
  }

  synchronized void each(BiConsumer<Ros2Name, Endpoint> visitor) {
    nodes.forEach((node, ends) -> ends.forEach(end -> visitor.accept(node, end)));
  }

  synchronized Entities entities(Guid participant) {
    return new Entities(participant, nodes.entrySet().stream()
        .map(node -> new Entities.Node(node.getKey().namespace().text(), node.getKey().base(),
            guids(node.getValue(), EndpointKind.READER), guids(node.getValue(), EndpointKind.WRITER)))
        .toList());
  }

  private static List<Guid> guids(List<Endpoint> ends, EndpointKind kind) {
    return ends.stream().map(Endpoint::info).filter(info -> info.kind() == kind).map(info -> info.guid()).toList();
  }
}
