package org.robotui.message.topic;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.robotui.api.RficContext;
import org.robotui.message.data.MessageForm;
import org.robotui.message.ros.std_msgs.StdString;

/**
 * What the robot is made of, by the topics {@code robot_description} and {@code robot_description_semantic}, which keep
 * the last text for those who come late. For the thread that follows the graph, but for closing.
 */
public final class DescriptionTopics implements AutoCloseable {
  private static final String TYPE = "std_msgs/String";

  private final TopicClient client;
  private final DescriptionPort port;
  private final Map<String, Consumer<String>> takers;
  private final Map<String, TopicSubscription> subscriptions = new HashMap<>();
  private final Map<String, String> elsewhere = new ConcurrentHashMap<>();
  private boolean closed;

  /**
   * Knows nothing yet.
   *
   * @param context what core gives
   * @param settings names the topics
   * @param packages folders in which packages are looked for that a description names
   * @param client subscribes
   */
  public DescriptionTopics(RficContext context, TopicSettings settings, List<String> packages, TopicClient client) {
    this.client = client;
    this.port = new DescriptionPort(context, settings, "the topic", packages);
    this.takers = Map.of(port.source(), port::model, port.source() + DescriptionPort.SEMANTIC, port::semantics);
  }

  /**
   * Where packages of ROS are on this machine.
   *
   * @param variables those of the environment: {@code AMENT_PREFIX_PATH} and {@code ROS_PACKAGE_PATH}
   * @return folders that contain packages
   */
  public static List<String> packages(Map<String, String> variables) {
    Stream<String> shares =
        paths(variables, "AMENT_PREFIX_PATH").map(prefix -> Path.of(prefix, "share").toString());
    return Stream.concat(shares, paths(variables, "ROS_PACKAGE_PATH")).toList();
  }

  private static Stream<String> paths(Map<String, String> variables, String name) {
    return Stream.of(variables.getOrDefault(name, "").split(":")).filter(folder -> folder.startsWith("/"));
  }

  /**
   * Listens to those that are published.
   *
   * @param graph what there is now
   * @return what is left to others
   */
  public synchronized TopicGraph follow(TopicGraph graph) {
    Map<String, String> left = new HashMap<>(graph.published());
    takers.forEach((topic, taker) -> {
      boolean published = left.remove(topic, TYPE);
      if (published && !closed) {
        subscriptions.computeIfAbsent(topic, name -> subscribe(name, taker));
      } else if (!published) {
        end(topic);
        taker.accept(elsewhere.getOrDefault(topic, ""));
      }
    });
    return new TopicGraph(left, graph.subscribed());
  }

  /**
   * Whether no topic of a name is published.
   *
   * @param name a global name
   * @return true where it must be looked for elsewhere
   */
  public synchronized boolean lacks(String name) {
    return !closed && !subscriptions.containsKey(name);
  }

  /**
   * Takes a text that came otherwise than by a topic, for the time in which there is none. Any thread.
   *
   * @param name the global name of the topic
   * @param text the text; empty where there is none any more
   */
  public void elsewhere(String name, String text) {
    elsewhere.put(name, text);
  }

  private TopicSubscription subscribe(String topic, Consumer<String> taker) {
    return client.subscribe(topic, TYPE, new MessageForm.Bound<>(StdString.class, false), new TopicListener<>() {
      @Override
      public void received(StdString message, Arrival arrival) {
        taker.accept(message.data());
      }

      @Override
      public void unreadable(String reason, Arrival arrival) {
        taker.accept("");
      }
    });
  }

  private void end(String topic) {
    Optional.ofNullable(subscriptions.remove(topic)).ifPresent(TopicSubscription::close);
  }

  /** Offers and publishes what came since. */
  public void tick() {
    port.tick();
  }

  /** Withdraws the offer. */
  @Override
  public synchronized void close() {
    closed = true;
    List.copyOf(subscriptions.keySet()).forEach(this::end);
    port.close();
  }
}
