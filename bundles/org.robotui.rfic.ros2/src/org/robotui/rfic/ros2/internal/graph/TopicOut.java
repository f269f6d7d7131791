package org.robotui.rfic.ros2.internal.graph;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.robotui.message.topic.TopicPublisher;
import org.robotui.ros2.Ros2Publisher;

/**
 * A topic that we publish. What waits for a subscriber is no more than the depth of the publisher, so that a stop takes
 * the place of what is late.
 *
 * @param <M> the Java value of a message
 * @param publisher says it
 */
record TopicOut<M>(Ros2Publisher<M> publisher) implements TopicPublisher<M> {
  @Override
  public int subscribers() {
    return publisher.numSubscribers();
  }

  @Override
  public Optional<String> obstacle() {
    List<String> reasons = publisher.mismatches();
    return reasons.isEmpty() ? Optional.empty()
        : Optional.of("nobody hears " + publisher.topic() + ": " + String.join("; ", reasons));
  }

  @Override
  public void publish(M message) {
    publisher.publish(message);
  }

  @Override
  public void publishUrgently(M message) {
    publisher.publish(message);
  }

  @Override
  public void awaitSent(Duration patience) {
    publisher.awaitSent(patience);
  }

  @Override
  public void close() {
    publisher.close();
  }
}
