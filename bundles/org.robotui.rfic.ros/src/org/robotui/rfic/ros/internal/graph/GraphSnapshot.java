package org.robotui.rfic.ros.internal.graph;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.robotui.ros.Outcome;
import org.robotui.ros.RosNode;
import org.robotui.ros.SystemState;
import org.robotui.ros.TopicInfo;

/**
 * Who else, beside this process, publishes and subscribes what, at one moment.
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
    Predicate<String> ours = ours(node.name().text());
    return node.master().topicTypes().map(types -> of(done.value(), types, ours));
  }

  /**
   * Our node, and others of this process, which anonymous names tell by its id: what one of our interfaces listens to, be it one on trial,
   * is nothing that the robot takes commands by.
   */
  private static Predicate<String> ours(String self) {
    int end = self.lastIndexOf('_');
    int begin = end < 0 ? -1 : self.lastIndexOf('_', end - 1);
    String process = begin < 0 ? self : self.substring(begin, end + 1);
    return begin < 0 ? self::equals : name -> name.startsWith(process, name.lastIndexOf('_', Math.max(0, name.lastIndexOf('_') - 1)));
  }

  private static GraphSnapshot of(SystemState state, List<TopicInfo> types, Predicate<String> self) {
    Map<String, String> byTopic = new HashMap<>();
    types.forEach(t -> byTopic.put(t.name(), t.type()));
    return new GraphSnapshot(
        typed(state.publishers(), byTopic, self), typed(state.subscribers(), byTopic, self));
  }

  /** Topics of others whose type is known; tools such as rostopic register subscriptions of type "*". */
  private static Map<String, String> typed(Map<String, List<String>> topics, Map<String, String> types, Predicate<String> self) {
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
