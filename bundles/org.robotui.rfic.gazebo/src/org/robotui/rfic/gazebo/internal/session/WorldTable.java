package org.robotui.rfic.gazebo.internal.session;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.robotui.gazebo.GazeboGraph;
import org.robotui.gazebo.OfferedService;
import org.robotui.gazebo.OfferedTopic;
import org.robotui.message.data.GazeboPoses;
import org.robotui.message.topic.TopicGraph;
import org.robotui.message.topic.TopicSettings;

/**
 * What the processes of a partition have, at one moment, by name.
 *
 * @param graph all of it
 * @param published types by topic; where several types are published, the one that was announced first
 */
public record WorldTable(GazeboGraph graph, Map<String, String> published) {
  static final WorldTable EMPTY = new WorldTable(GazeboGraph.EMPTY, Map.of());

  private static final String TWIST = "geometry_msgs/Twist";
  /** What those subscribe to who take messages of every type. */
  private static final String ANY = "google.protobuf.Message";
  private static final String ODOMETRY = "/odometry";

  static WorldTable of(GazeboGraph graph) {
    Map<String, String> published = new TreeMap<>();
    graph.topics().forEach(each -> published.putIfAbsent(each.name().name(), each.type()));
    return new WorldTable(graph, published);
  }

  /** Whether a simulator is there, or anything else that has something. */
  boolean isInhabited() {
    return !graph.topics().isEmpty() || !graph.services().isEmpty();
  }

  /**
   * Who publishes a topic.
   *
   * @param topic its name
   * @return one for each node
   */
  public List<OfferedTopic> publishers(String topic) {
    return graph.topics().stream().filter(each -> each.name().name().equals(topic)).toList();
  }

  /**
   * A service by its name.
   *
   * @param name of it
   * @return the first that answers
   */
  public Optional<OfferedService> service(String name) {
    return graph.services().stream().filter(each -> each.name().name().equals(name)).findFirst();
  }

  /** Topics that say where things are. Of those of a world the one that says all of it is enough. */
  Map<String, String> poses() {
    Map<String, String> poses = new HashMap<>();
    published.forEach((topic, type) -> {
      String whole = topic.replace("/dynamic_pose/info", "/pose/info");
      if (GazeboPoses.is(type) && (whole.equals(topic) || !published.containsKey(whole))) {
        poses.put(topic, type);
      }
    });
    return poses;
  }

  /** How types are called here: as newer releases do, or as older ones. */
  String prefix() {
    return Stream.concat(published.values().stream(), graph.services().stream().map(OfferedService::request))
        .anyMatch(type -> type.startsWith("ignition.msgs.")) ? "ignition.msgs." : "gz.msgs.";
  }

  /**
   * Topics as ports. A simulator does not say who subscribes to what before it is published: a base that publishes its
   * odometry is driven by the topic beside it.
   */
  TopicGraph ports(TopicSettings settings) {
    Map<String, String> types = new HashMap<>(published);
    poses().keySet().forEach(types::remove);
    Map<String, String> taken = new HashMap<>();
    graph.subscriptions().forEach(each -> taken.put(each.name().name(), commandType(each.type())));
    taken.values().removeIf(ANY::equals);
    published.keySet().stream().filter(topic -> topic.startsWith("/model/") && topic.endsWith(ODOMETRY))
        .map(topic -> topic.substring(0, topic.length() - ODOMETRY.length()) + "/cmd_vel")
        .forEach(topic -> taken.put(topic, TWIST));
    return new TopicGraph(types, taken);
  }

  /** The type of ROS that commands the same; the type itself where there is none. */
  static String commandType(String type) {
    return type.equals("gz.msgs.Twist") || type.equals("ignition.msgs.Twist") ? TWIST : type;
  }

  /**
   * Topics that somebody publishes, or to which somebody has said to subscribe.
   *
   * @return types by name
   */
  public Map<String, String> known() {
    Map<String, String> known = new TreeMap<>(published);
    graph.subscriptions().stream().filter(each -> !each.type().equals(ANY))
        .forEach(each -> known.putIfAbsent(each.name().name(), each.type()));
    return known;
  }
}
