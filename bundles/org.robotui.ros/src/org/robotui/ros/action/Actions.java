package org.robotui.ros.action;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.InvalidNameException;
import org.robotui.ros.MasterGraph;
import org.robotui.ros.SystemState;
import org.robotui.ros.TopicInfo;

/**
 * Finds actions by their topics: a node that publishes {@code X/status} and subscribes to {@code X/goal} serves action
 * X.
 */
public final class Actions {

  private static final String STATUS = "/status";
  private static final String STATUS_TYPE = "actionlib_msgs/GoalStatusArray";

  private Actions() {}

  /**
   * Asks the master for all actions. Waits for the master.
   *
   * @param graph asks the master
   * @return the actions, sorted by name, or why the master did not answer
   */
  public static Outcome<List<ActionInfo>> list(MasterGraph graph) {
    Outcome<SystemState> state = graph.systemState();
    if (!(state instanceof Outcome.Done<SystemState> known)) {
      return state.map(never -> List.of());
    }
    return graph.topicTypes().map(types -> find(known.value(), types));
  }

  /**
   * Finds the actions in what the master said before.
   *
   * @param state who publishes and subscribes what
   * @param types the types of topics
   * @return the actions, sorted by name
   */
  public static List<ActionInfo> find(SystemState state, List<TopicInfo> types) {
    Map<String, String> byTopic = new HashMap<>();
    types.forEach(topic -> byTopic.put(topic.name(), topic.type()));
    return state.publishers().keySet().stream().sorted()
        .filter(topic -> topic.endsWith(STATUS) && topic.length() > STATUS.length())
        .filter(topic -> STATUS_TYPE.equals(byTopic.get(topic)))
        .flatMap(topic -> action(topic.substring(0, topic.length() - STATUS.length()), state, byTopic).stream())
        .toList();
  }

  private static Optional<ActionInfo> action(String name, SystemState state, Map<String, String> types) {
    List<String> servers = new ArrayList<>(state.publishers().getOrDefault(name + STATUS, List.of()));
    servers.retainAll(state.subscribers().getOrDefault(name + "/goal", List.of()));
    if (servers.isEmpty()) {
      return Optional.empty();
    }
    try {
      return Optional.of(new ActionInfo(GraphName.of(name), type(name, types), servers.get(0)));
    } catch (InvalidNameException e) {
      return Optional.empty();
    }
  }

  private static String type(String name, Map<String, String> types) {
    for (String part : List.of("Goal", "Result", "Feedback")) {
      String found = types.getOrDefault(name + "/" + part.toLowerCase(java.util.Locale.ROOT), "*");
      if (found.endsWith("Action" + part)) {
        return found.substring(0, found.length() - part.length());
      }
    }
    return "*";
  }
}
