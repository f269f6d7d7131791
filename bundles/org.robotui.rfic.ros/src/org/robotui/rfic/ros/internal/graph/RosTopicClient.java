package org.robotui.rfic.ros.internal.graph;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageSchema;
import org.robotui.message.RawCodec;
import org.robotui.message.RecordCodec;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.MessageForm;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.RecordedDefinitions;
import org.robotui.message.topic.TopicClient;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicPublisher;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.rfic.ros.internal.convert.MessageReading;
import org.robotui.rfic.ros.internal.convert.RecordDecoder;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.Reception;
import org.robotui.ros.RosNode;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;

/** The topics of ROS 1, through a node. */
final class RosTopicClient implements TopicClient {
  /** As values name it that were received; what was received is relayed by the same name. */
  static final String ENCODING = "ros1";
  private static final int MOST_RELAYED = 100;

  private final RosNode node;
  private final RecordDecoder records;
  private final LinkWatch watch;

  RosTopicClient(RosNode node, RecordDecoder records, LinkWatch watch) {
    this.node = node;
    this.records = records;
    this.watch = watch;
  }

  @Override
  public <M> TopicSubscription subscribe(String topic, String type, MessageForm<M> form, TopicListener<M> listener) {
    return subscribe(topic, MessageReading.of(form, records), listener);
  }

  private <R, M> TopicSubscription subscribe(String topic, MessageReading<R, M> reading, TopicListener<M> listener) {
    return new Subscribed(topic, watch, node.subscriber(topic, reading.codec(), SubscriberOptions.observing(),
        (message, reception) -> received(message, reading.message(), arrival(topic, reception), listener)));
  }

  private static <R, M> void received(R received, Function<R, M> reading, Arrival arrival, TopicListener<M> listener) {
    M message;
    try {
      message = reading.apply(received);
    } catch (IllegalArgumentException e) {
      listener.unreadable(String.valueOf(e.getMessage()), arrival);
      return;
    }
    listener.received(message, arrival);
  }

  private Arrival arrival(String topic, Reception reception) {
    ByteBuffer bytes = reception.raw();
    return new Arrival(reception.callerId(), reception.receiveNanos(), reception.latched(), ENCODING, bytes,
        raw -> records.read(reception.peer(), raw), topic, () -> RecordedDefinitions.announced(reception.peer()));
  }

  @Override
  public <M extends Record> TopicPublisher<M> commands(String topic, String type, Class<M> form, int mostWaiting) {
    return new Published<>(
        node.publisher(topic, RecordCodec.of(form), PublisherOptions.commands().withQueue(mostWaiting)));
  }

  @Override
  public TopicPublisher<DynamicMessage> messages(String topic, MessageSchema schema) {
    return new Published<>(
        node.publisher(topic, new DynamicCodec(schema), PublisherOptions.standard().withQueue(1)));
  }

  @Override
  public TopicPublisher<DynamicMessage> relayed(String topic, MessageSchema schema, boolean kept) {
    PublisherOptions options = kept ? PublisherOptions.latched() : PublisherOptions.standard();
    return new RelayedTopic(
        node.publisher(topic, new RawCodec(schema.info()), options.withQueue(MOST_RELAYED)), schema.info());
  }

  @Override
  public SchemaLookup<MessageSchema> schema(String type) {
    return records.registry().message(type);
  }

  @Override
  public Optional<String> failure(String topic) {
    return watch.failure(topic);
  }

  @Override
  public boolean isSimulated() {
    return node.clock().isSimulated();
  }

  @Override
  public long nowNanos() {
    return node.clock().nowNanos();
  }

  @Override
  public String name() {
    return node.name().text();
  }

  private record Subscribed(String topic, LinkWatch watch, Subscriber subscriber) implements TopicSubscription {
    @Override
    public int publishers() {
      return subscriber.numPublishers();
    }

    @Override
    public Lost lost() {
      Subscriber.Unreadable unreadable = subscriber.unreadable();
      return new Lost(unreadable.count(), unreadable.reason());
    }

    @Override
    public void close() {
      subscriber.close();
      watch.forget(topic);
    }
  }

  private record Published<M>(Publisher<M> publisher) implements TopicPublisher<M> {
    @Override
    public int subscribers() {
      return publisher.numSubscribers();
    }

    @Override
    public void publish(M message) {
      publisher.publish(message);
    }

    @Override
    public void publishUrgently(M message) {
      publisher.publishUrgently(message);
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
}
