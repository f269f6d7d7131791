package org.robotui.ros.reconfigure;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.robotui.net.call.Outcome;
import org.robotui.ros.MasterGraph;
import org.robotui.ros.SystemState;
import org.robotui.ros.TopicInfo;

/** Finds servers: a service {@code X/set_parameters} beside a topic {@code X/parameter_descriptions}. */
public final class ReconfigureServers {

  private static final String SERVICE = "/set_parameters";
  private static final String TOPIC = "/parameter_descriptions";
  private static final String TYPE = "dynamic_reconfigure/ConfigDescription";

  private ReconfigureServers() {}

  /**
   * Asks the master for all servers. Waits for the master.
   *
   * @param graph asks the master
   * @return the servers' names X, sorted, or why the master did not answer
   */
  public static Outcome<List<String>> list(MasterGraph graph) {
    Outcome<SystemState> state = graph.systemState();
    if (!(state instanceof Outcome.Done<SystemState> known)) {
      return state.map(never -> List.of());
    }
    return graph.topicTypes().map(types -> find(known.value(), types));
  }

  /**
   * Finds the servers in what the master said before.
   *
   * @param state who publishes and serves what
   * @param types the types of topics
   * @return the servers' names X, sorted
   */
  public static List<String> find(SystemState state, List<TopicInfo> types) {
    Map<String, String> byTopic = new HashMap<>();
    types.forEach(topic -> byTopic.put(topic.name(), topic.type()));
    return state.services().keySet().stream().filter(service -> service.endsWith(SERVICE))
        .map(service -> service.substring(0, service.length() - SERVICE.length()))
        .filter(name -> state.publishers().containsKey(name + TOPIC) && Objects.equals(byTopic.get(name + TOPIC), TYPE))
        .sorted().toList();
  }
}
