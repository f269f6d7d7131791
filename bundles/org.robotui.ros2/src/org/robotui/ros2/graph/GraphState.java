package org.robotui.ros2.graph;

import java.util.List;
import java.util.Optional;
import org.robotui.ros2.name.Ros2Name;

/**
 * Who is in the domain, at one moment.
 *
 * @param nodes by name
 * @param topics by name, without those of actions
 * @param services by name, without those of actions
 * @param actions by name
 */
public record GraphState(List<GraphNode> nodes, List<GraphTopic> topics, List<GraphService> services,
    List<GraphAction> actions) {

  /** Copies the lists. */
  public GraphState {
    nodes = List.copyOf(nodes);
    topics = List.copyOf(topics);
    services = List.copyOf(services);
    actions = List.copyOf(actions);
  }

  /**
   * One topic.
   *
   * @param name its whole name
   * @return empty if nobody has it
   */
  public Optional<GraphTopic> topic(Ros2Name name) {
    return topics.stream().filter(topic -> topic.name().equals(name)).findFirst();
  }

  /**
   * One service.
   *
   * @param name its whole name
   * @return empty if nobody has it
   */
  public Optional<GraphService> service(Ros2Name name) {
    return services.stream().filter(service -> service.name().equals(name)).findFirst();
  }

  /**
   * One action.
   *
   * @param name its whole name
   * @return empty if nobody has it
   */
  public Optional<GraphAction> action(Ros2Name name) {
    return actions.stream().filter(action -> action.name().equals(name)).findFirst();
  }

  /**
   * One node.
   *
   * @param name its whole name
   * @return empty if it is not there
   */
  public Optional<GraphNode> node(Ros2Name name) {
    return nodes.stream().filter(node -> node.name().equals(name)).findFirst();
  }
}
