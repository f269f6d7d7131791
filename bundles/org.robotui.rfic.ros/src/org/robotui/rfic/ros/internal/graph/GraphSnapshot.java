package org.robotui.rfic.ros.internal.graph;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.robotui.message.topic.TopicGraph;

/** Who else, beside this process, publishes and subscribes what, as a master says it. */
final class GraphSnapshot {
  private static final String ANY = "*";

  private GraphSnapshot() {}

  /** What others do, seen from one node. */
  static TopicGraph of(SharedGraph graph, String self) {
    Predicate<String> ours = ours(self);
    return new TopicGraph(
        typed(graph.state().publishers(), graph.types(), ours),
        typed(graph.state().subscribers(), graph.types(), ours));
  }

  /**
   * Our node, and others of this process, which anonymous names tell by its id: what one of our interfaces listens to,
   * be it one on trial, is nothing that the robot takes commands by.
   */
  private static Predicate<String> ours(String self) {
    int end = self.lastIndexOf('_');
    int begin = end < 0 ? -1 : self.lastIndexOf('_', end - 1);
    String process = begin < 0 ? self : self.substring(begin, end + 1);
    return begin < 0 ? self::equals
        : name -> name.startsWith(process, name.lastIndexOf('_', Math.max(0, name.lastIndexOf('_') - 1)));
  }

  /** Topics of others whose type is known; tools such as rostopic register subscriptions of type "*". */
  private static Map<String, String> typed(Map<String, List<String>> topics, Map<String, String> types,
      Predicate<String> self) {
    Map<String, String> typed = new TreeMap<>();
    topics.forEach((topic, nodes) -> {
      String type = types.getOrDefault(topic, ANY);
      if (!ANY.equals(type) && nodes.stream().anyMatch(Predicate.not(self))) {
        typed.put(topic, type);
      }
    });
    return typed;
  }
}
