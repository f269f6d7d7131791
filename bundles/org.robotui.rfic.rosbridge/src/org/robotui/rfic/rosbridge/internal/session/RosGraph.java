package org.robotui.rfic.rosbridge.internal.session;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.robotui.message.Generation;
import org.robotui.message.payload.RosDefinitions;
import org.robotui.message.topic.TopicGraph;
import org.robotui.rosbridge.RosApi.NodeDetails;

/**
 * Which node publishes and subscribes what, at one moment.
 *
 * @param types by topic, as the bridge writes them
 * @param nodes by name
 */
public record RosGraph(Map<String, String> types, Map<String, NodeDetails> nodes) {
  static final RosGraph EMPTY = new RosGraph(Map.of(), Map.of());
  /** What belongs to the bridge publishes and subscribes for its clients, of which we are one. */
  private static final List<String> BRIDGES = List.of("rosbridge", "rosapi");

  /**
   * The topics with those who are at one of their ends.
   *
   * @param sends whether those are meant who publish
   * @return nodes by topic, without those of the bridge
   */
  public Map<String, Set<String>> ends(boolean sends) {
    Map<String, Set<String>> ends = new TreeMap<>();
    nodes.forEach((name, details) -> {
      if (BRIDGES.stream().noneMatch(name.substring(name.lastIndexOf('/') + 1)::startsWith)) {
        (sends ? details.publishing() : details.subscribing())
            .forEach(topic -> ends.computeIfAbsent(topic, t -> new TreeSet<>()).add(name));
      }
    });
    return ends;
  }

  TopicGraph topics() {
    return new TopicGraph(typed(ends(true)), typed(ends(false)));
  }

  private Map<String, String> typed(Map<String, Set<String>> ends) {
    Map<String, String> typed = new HashMap<>();
    ends.keySet().stream().filter(topic -> !types.getOrDefault(topic, "").isEmpty())
        .forEach(topic -> typed.put(topic, Generation.plainName(types.get(topic))));
    return typed;
  }

  /**
   * Which ROS it is, by how it writes the names of types.
   *
   * @return the generation
   */
  public Generation generation() {
    return types.values().stream().anyMatch(RosDefinitions::isOfThreeParts) ? Generation.ROS2 : Generation.ROS1;
  }

  /** The type as the bridge writes it. */
  String written(String type) {
    return generation() == Generation.ROS2 && !RosDefinitions.isOfThreeParts(type) ? type.replaceFirst("/", "/msg/")
        : type;
  }
}
