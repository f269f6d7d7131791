package org.robotui.rfic.ros2.internal.graph;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.robotui.message.SchemaLookup;
import org.robotui.message.description.TypeHash;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.rfic.ros2.internal.convert.VersionedReading;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Listener;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Subscriber;
import org.robotui.ros2.Ros2SubscriberOptions;

/**
 * A topic that we listen to, from when its type is known: what a publisher keeps for late subscribers comes once, and
 * would be lost before. Safe for all threads.
 *
 * @param <M> the Java value of a message
 */
final class TopicIn<M> implements TopicSubscription {
  private final Ros2Node node;
  private final String topic;
  private final VersionedReading<M> reading;
  private final Supplier<Optional<TypeHash>> announced;
  private final Ros2Codec<ByteBuffer> codec;
  private final Ros2Listener<ByteBuffer> listener;
  private final Consumer<TopicIn<?>> ended;
  private Optional<Ros2Subscriber> subscriber = Optional.empty();
  private String obstacle = "";
  private boolean closed;

  TopicIn(Ros2Node node, String topic, VersionedReading<M> reading, Supplier<Optional<TypeHash>> announced,
      Ros2Codec<ByteBuffer> codec, Ros2Listener<ByteBuffer> listener, Consumer<TopicIn<?>> ended) {
    this.node = node;
    this.topic = topic;
    this.reading = reading;
    this.announced = announced;
    this.codec = codec;
    this.listener = listener;
    this.ended = ended;
  }

  /** Subscribes if the type is known by now. */
  synchronized void advance() {
    if (closed || subscriber.isPresent()) {
      return;
    }
    Optional<SchemaLookup<Ros2Codec<?>>> known = reading.codec(announced.get());
    obstacle = known.orElse(null) instanceof SchemaLookup.Missing<Ros2Codec<?>> missing ? missing.reason() : "";
    if (known.orElse(null) instanceof SchemaLookup.Found) {
      subscriber = Optional.of(node.subscriber(topic, codec, Ros2SubscriberOptions.observing(), listener));
    }
  }

  synchronized Optional<String> failure() {
    String reason = subscriber.map(open -> String.join("; ", open.mismatches())).orElse(obstacle);
    return reason.isEmpty() ? Optional.empty() : Optional.of(topic + ": " + reason);
  }

  @Override
  public synchronized int publishers() {
    return subscriber.map(Ros2Subscriber::numPublishers).orElse(0);
  }

  @Override
  public Lost lost() {
    return open().map(now -> new Lost(now.lost(), topic + ": messages that were published did not come"))
        .orElse(Lost.NONE);
  }

  private synchronized Optional<Ros2Subscriber> open() {
    return subscriber;
  }

  @Override
  public synchronized void close() {
    closed = true;
    subscriber.ifPresent(Ros2Subscriber::close);
    subscriber = Optional.empty();
    ended.accept(this);
  }
}
