package org.robotui.sim.internal.ros;

import java.util.function.Function;
import org.robotui.message.MessageCodec;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;

/** A publisher that numbers its messages. For one thread. */
final class Topic<T> {
  private static final int QUEUE = 50;
  private final Publisher<T> publisher;
  private final boolean latched;
  private long sequence;

  private Topic(Publisher<T> publisher, boolean latched) {
    this.publisher = publisher;
    this.latched = latched;
  }

  static <T> Topic<T> plain(RosNode node, String name, MessageCodec<T> codec) {
    return new Topic<>(node.publisher(name, codec, PublisherOptions.standard().withQueue(QUEUE)), false);
  }

  static <T> Topic<T> latched(RosNode node, String name, MessageCodec<T> codec) {
    return new Topic<>(node.publisher(name, codec, PublisherOptions.latched().withQueue(QUEUE)), true);
  }

  /** Whether anybody would see a message. */
  boolean isWanted() {
    return latched || publisher.numSubscribers() > 0;
  }

  /** Makes a message and publishes it, unless nobody would see it. */
  void publish(long nanos, Function<Stamp, T> message) {
    sequence++;
    if (isWanted()) {
      publisher.publish(message.apply(new Stamp(sequence, nanos)));
    }
  }
}
