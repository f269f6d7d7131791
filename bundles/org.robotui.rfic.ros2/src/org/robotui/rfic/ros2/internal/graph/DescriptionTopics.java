package org.robotui.rfic.ros2.internal.graph;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.api.RficContext;
import org.robotui.message.data.MessageForm;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.DescriptionPort;
import org.robotui.message.topic.TopicClient;
import org.robotui.message.topic.TopicGraph;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.rfic.ros2.internal.Ros2Settings;

/**
 * What the robot is made of, by the topics {@code robot_description} and {@code robot_description_semantic}, which keep
 * the last text for those who come late. For the thread that follows the graph, but for closing.
 */
final class DescriptionTopics implements AutoCloseable {
  private static final String TYPE = "std_msgs/String";

  private final TopicClient client;
  private final DescriptionPort port;
  private final Map<String, Consumer<String>> takers;
  private final Map<String, TopicSubscription> subscriptions = new HashMap<>();
  private boolean closed;

  DescriptionTopics(RficContext context, Ros2Settings settings, TopicClient client) {
    this.client = client;
    this.port = new DescriptionPort(context, settings.topics(), "the topic", settings.packages());
    this.takers = Map.of(port.source(), port::model, port.source() + DescriptionPort.SEMANTIC, port::semantics);
  }

  /** Listens to those that are published; answers what is left to others. */
  synchronized TopicGraph follow(TopicGraph graph) {
    Map<String, String> left = new HashMap<>(graph.published());
    takers.forEach((topic, taker) -> {
      boolean published = left.remove(topic, TYPE);
      if (published && !closed) {
        subscriptions.computeIfAbsent(topic, name -> subscribe(name, taker));
      } else if (!published) {
        end(topic);
        taker.accept("");
      }
    });
    return new TopicGraph(left, graph.subscribed());
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

  void tick() {
    port.tick();
  }

  @Override
  public synchronized void close() {
    closed = true;
    List.copyOf(subscriptions.keySet()).forEach(this::end);
    port.close();
  }
}
