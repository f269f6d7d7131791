package org.robotui.rfic.ros.internal.graph;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.robotui.net.call.Outcome;
import org.robotui.ros.RosNode;
import org.robotui.ros.SystemState;
import org.robotui.ros.TopicInfo;

/**
 * Who publishes and subscribes what, at one moment, as the master says it.
 *
 * @param state the nodes of each topic
 * @param types type by topic
 * @param namespaces the first part of the names of topics in namespaces
 */
record SharedGraph(SystemState state, Map<String, String> types, Set<String> namespaces) {
  static Outcome<SharedGraph> ask(RosNode node) {
    Outcome<SystemState> state = node.master().systemState();
    return state instanceof Outcome.Done<SystemState> done
        ? node.master().topicTypes().map(types -> of(done.value(), types))
        : state.map(s -> new SharedGraph(s, Map.of(), Set.of()));
  }

  private static SharedGraph of(SystemState state, List<TopicInfo> types) {
    Map<String, String> byTopic = new HashMap<>();
    types.forEach(t -> byTopic.put(t.name(), t.type()));
    Set<String> namespaces = new HashSet<>();
    state.publishers().keySet().forEach(topic -> {
      int end = topic.indexOf('/', 1);
      if (end > 1) {
        namespaces.add(topic.substring(1, end));
      }
    });
    return new SharedGraph(state, byTopic, namespaces);
  }
}
