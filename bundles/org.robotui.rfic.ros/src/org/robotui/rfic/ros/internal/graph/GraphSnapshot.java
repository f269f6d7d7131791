package org.robotui.rfic.ros.internal.graph;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.robotui.ros.Outcome;
import org.robotui.ros.RosNode;
import org.robotui.ros.SystemState;
import org.robotui.ros.TopicInfo;

/**
 * Who else publishes and subscribes what, at one moment.
 *
 * @param published type by topic, of topics that others publish
 * @param subscribed type by topic, of topics to which others subscribe
 */
record GraphSnapshot(Map<String, String> published, Map<String, String> subscribed) {
  private static final String ANY = "*";

  static Outcome<GraphSnapshot> take(RosNode node) {
    Outcome<SystemState> state = node.master().systemState();
    if (!(state instanceof Outcome.Done<SystemState> done)) {
      return state.map(s -> new GraphSnapshot(Map.of(), Map.of()));
    }
    String self = node.name().text();
    return node.master().topicTypes().map(types -> of(done.value(), types, self));
  }

  private static GraphSnapshot of(SystemState state, List<TopicInfo> types, String self) {
    Map<String, String> byTopic = new HashMap<>();
    types.forEach(t -> byTopic.put(t.name(), t.type()));
    return new GraphSnapshot(
        typed(state.publishers(), byTopic, self), typed(state.subscribers(), byTopic, self));
  }

  /** Topics of others whose type is known; tools such as rostopic register subscriptions of type "*". */
  private static Map<String, String> typed(Map<String, List<String>> topics, Map<String, String> types, String self) {
    Map<String, String> typed = new TreeMap<>();
    topics.forEach((topic, nodes) -> {
      String type = types.getOrDefault(topic, ANY);
      if (!ANY.equals(type) && nodes.stream().anyMatch(n -> !n.equals(self))) {
        typed.put(topic, type);
      }
    });
    return typed;
  }
}
