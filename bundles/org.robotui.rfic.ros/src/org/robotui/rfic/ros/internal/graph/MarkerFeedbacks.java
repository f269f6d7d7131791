package org.robotui.rfic.ros.internal.graph;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.api.link.Pulse;
import org.robotui.api.port.CommandSink;
import org.robotui.data.marker.MarkerFeedback;
import org.robotui.message.RecordCodec;
import org.robotui.message.data.InteractiveMarkers;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerFeedback;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;

/**
 * Tells servers of interactive markers what users do. A topic is advertised as long as its markers are looked at, so
 * that the first grip is not lost while the server connects. Safe for all threads.
 */
final class MarkerFeedbacks implements CommandSink<MarkerFeedback> {
  /** A click is several messages at once, of which none may be lost. */
  private static final int MOST_WAITING = 16;

  private final RosNode node;
  private final Pulse pulse;
  private final Map<String, Publisher<InteractiveMarkerFeedback>> topics = new ConcurrentHashMap<>();

  MarkerFeedbacks(RosNode node, Pulse pulse) {
    this.node = node;
    this.pulse = pulse;
  }

  void open(String topic) {
    topics.computeIfAbsent(topic, t -> node.publisher(t, RecordCodec.of(InteractiveMarkerFeedback.class),
        PublisherOptions.commands().withQueue(MOST_WAITING)));
  }

  void close(String topic) {
    Publisher<InteractiveMarkerFeedback> publisher = topics.remove(topic);
    if (publisher != null) {
      publisher.close();
    }
  }

  @Override
  public Sent send(MarkerFeedback feedback) {
    Publisher<InteractiveMarkerFeedback> publisher = topics.get(feedback.topic());
    if (publisher == null) {
      return new Sent.Refused("no interactive markers are looked at on " + feedback.topic());
    }
    if (publisher.numSubscribers() == 0) {
      return new Sent.Refused("nobody subscribes to " + feedback.topic() + " now");
    }
    if (pulse.silentFor(System.nanoTime()) > 0) {
      return new Sent.Refused("the robot is not heard; nothing is sent into a network that may keep it");
    }
    publisher.publish(InteractiveMarkers.feedback(feedback, node.name().text()));
    return new Sent.Out();
  }
}
