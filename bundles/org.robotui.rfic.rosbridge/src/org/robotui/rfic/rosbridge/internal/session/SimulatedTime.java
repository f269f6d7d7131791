package org.robotui.rfic.rosbridge.internal.session;

import java.util.Optional;
import java.util.OptionalLong;
import org.robotui.message.data.MessageForm;
import org.robotui.message.ros.rosgraph_msgs.Clock;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicSubscription;

/** The time of a robot that is simulated or played back: somebody then publishes {@code /clock}. */
final class SimulatedTime implements TopicListener<Clock> {
  private static final String TOPIC = "/clock";

  private Optional<TopicSubscription> subscription = Optional.empty();
  private volatile OptionalLong nanos = OptionalLong.empty();

  /** Listens while somebody publishes it. For one thread. */
  void follow(BridgeTopics topics, RosGraph graph) {
    boolean there = graph.ends(true).containsKey(TOPIC);
    if (there && subscription.isEmpty()) {
      subscription = Optional.of(topics.subscribe(TOPIC, "rosgraph_msgs/Clock",
          new MessageForm.Bound<>(Clock.class, true), this));
    } else if (!there && subscription.isPresent()) {
      subscription.get().close();
      subscription = Optional.empty();
      nanos = OptionalLong.empty();
    }
  }

  OptionalLong now() {
    return nanos;
  }

  @Override
  public void received(Clock message, Arrival arrival) {
    nanos = OptionalLong.of(message.clock());
  }

  @Override
  public void unreadable(String reason, Arrival arrival) {
    // the next one tells
  }
}
