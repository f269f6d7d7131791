package org.robotui.message.topic.internal;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.api.link.Pulse;
import org.robotui.api.port.CommandSink;
import org.robotui.data.marker.MarkerFeedback;
import org.robotui.message.data.InteractiveMarkers;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerFeedback;
import org.robotui.message.topic.TopicClient;
import org.robotui.message.topic.TopicPublisher;

/**
 * Tells servers of interactive markers what users do. A topic is advertised as long as its markers are looked at, so
 * that the first grip is not lost while the server connects. Safe for all threads.
 */
public final class MarkerFeedbacks implements CommandSink<MarkerFeedback> {
  /** A click is several messages at once, of which none may be lost. */
  private static final int MOST_WAITING = 16;
  private static final String TYPE = "visualization_msgs/InteractiveMarkerFeedback";

  private final TopicClient client;
  private final Pulse pulse;
  private final Map<String, TopicPublisher<InteractiveMarkerFeedback>> topics = new ConcurrentHashMap<>();

  /**
   * Has no topics yet.
   *
   * @param client says what users do
   * @param pulse when the robot was heard last
   */
  public MarkerFeedbacks(TopicClient client, Pulse pulse) {
    this.client = client;
    this.pulse = pulse;
  }

  void open(String topic) {
    topics.computeIfAbsent(topic, t -> client.commands(t, TYPE, InteractiveMarkerFeedback.class, MOST_WAITING));
  }

  void close(String topic) {
    TopicPublisher<InteractiveMarkerFeedback> publisher = topics.remove(topic);
    if (publisher != null) {
      publisher.close();
    }
  }

  @Override
  public Sent send(MarkerFeedback feedback) {
    TopicPublisher<InteractiveMarkerFeedback> publisher = topics.get(feedback.topic());
    if (publisher == null) {
      return new Sent.Refused("no interactive markers are looked at on " + feedback.topic());
    }
    if (publisher.subscribers() == 0) {
      return new Sent.Refused("nobody subscribes to " + feedback.topic() + " now");
    }
    if (pulse.silentFor(System.nanoTime()) > 0) {
      return new Sent.Refused("the robot is not heard; nothing is sent into a network that may keep it");
    }
    publisher.publish(InteractiveMarkers.feedback(feedback, client.name()));
    return new Sent.Out();
  }
}
