package org.robotui.uic.graph.internal.model;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.port.SourceId;

/**
 * How the programs of all robots are connected, as they last said.
 *
 * @param ties each program with each topic that it sends or takes, without doubles, sorted
 * @param types the robot's name of the type, by topic
 * @param streams which stream carries which topic, where one does
 * @param known the robots that have ever answered
 * @param failures why robots do not answer now, by robot
 */
record Wiring(List<Tie> ties, Map<Vertex, String> types, Map<Vertex, SourceId> streams, Set<String> known,
    Map<String, String> failures) {
  static final Wiring NOTHING = new Wiring(List.of(), Map.of(), Map.of(), Set.of(), Map.of());

  /**
   * A program at an end of a topic.
   *
   * @param node the program
   * @param topic the topic
   * @param sends true where it publishes
   */
  record Tie(Vertex node, Vertex topic, boolean sends) {}

  Optional<SourceId> stream(Vertex topic) {
    return Optional.ofNullable(streams.get(topic));
  }
}
