package org.robotui.rfic.rosbridge.internal.session;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.Encoding;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.MessageForm;
import org.robotui.message.payload.JsonFormat;
import org.robotui.message.payload.RosFormat;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.RecordedDefinitions;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.rosbridge.BridgeMessage;
import org.robotui.rosbridge.BridgeReceiver;
import org.robotui.web.ArrivalSubscription;

/**
 * A topic that is received, from when the definition of its type is known.
 *
 * @param <M> the Java value of a message
 */
final class BridgeReception<M> implements TopicSubscription {
  private final Asked<M> asked;
  private final BridgeTopics topics;
  private final Consumer<BridgeReception<M>> end;
  private Optional<ArrivalSubscription> subscription = Optional.empty();
  private String failure = "";
  private long dropped;
  private boolean closed;

  /**
   * What is received.
   *
   * @param topic its name
   * @param type of two parts
   * @param form what messages are read as
   * @param most how many messages wait
   * @param listener is told
   * @param <M> the Java value of a message
   */
  record Asked<M>(String topic, String type, MessageForm<M> form, int most, TopicListener<M> listener) {}

  BridgeReception(Asked<M> asked, BridgeTopics topics, Consumer<BridgeReception<M>> end) {
    this.asked = asked;
    this.topics = topics;
    this.end = end;
  }

  String topic() {
    return asked.topic();
  }

  /** Begins, if it has not and can now. */
  synchronized void tick() {
    if (closed || subscription.isPresent() || !failure.isEmpty()) {
      return;
    }
    Optional<SchemaLookup<MessageSchema>> schema = topics.watch().schema(asked.type());
    if (schema.isEmpty()) {
      return;
    }
    switch (schema.get()) {
      case SchemaLookup.Found<MessageSchema> found -> begin(found.schema());
      case SchemaLookup.Missing<MessageSchema> missing -> failure = asked.topic() + ": " + missing.reason();
    }
  }

  private void begin(MessageSchema schema) {
    try {
      subscription = Optional.of(topics.receive(asked.topic(), asked.type(), asked.most(), new Reader(schema)));
    } catch (IllegalArgumentException e) {
      failure = asked.topic() + ": " + e.getMessage();
    }
  }

  /** Reads what comes by the definition of the robot, as bytes of its ROS or as a tree. */
  private final class Reader implements BridgeReceiver {
    private final MessageSchema schema;
    private final RosFormat raw;
    private final RosFormat packed;

    Reader(MessageSchema schema) {
      this.schema = schema;
      this.raw = new RosFormat(schema, topics.watch().graph().generation().encoding());
      this.packed = new RosFormat(schema, Encoding.ROS1);
      raw.reading(asked.form()); // says now what does not fit
    }

    @Override
    public void received(BridgeMessage message, long receivedNanos) {
      try {
        switch (message) {
          case BridgeMessage.Raw bytes -> deliver(raw, bytes.bytes(), receivedNanos);
          case BridgeMessage.Tree tree -> deliver(packed, JsonFormat.message(schema, tree.fields()).bytes(),
              receivedNanos);
        }
      } catch (IllegalArgumentException e) {
        unreadable(String.valueOf(e.getMessage()), receivedNanos);
      }
    }

    private void deliver(RosFormat format, ByteBuffer bytes, long receivedNanos) {
      M message = format.reading(asked.form()).read(bytes.duplicate());
      asked.listener().received(message, arrival(format, bytes, receivedNanos));
    }

    private Arrival arrival(RosFormat format, ByteBuffer bytes, long receivedNanos) {
      String encoding = format.encoding().equals(Encoding.CDR) ? "cdr" : "ros1";
      return new Arrival(topics.server(), receivedNanos, false, encoding, bytes.asReadOnlyBuffer(),
          all -> record(format, all), asked.topic(),
          () -> Optional.of(RecordedDefinitions.of(schema, format.encoding())));
    }

    private static Optional<DynamicRecord> record(RosFormat format, Bytes bytes) {
      try {
        return Optional.of(format.read(bytes.buffer(ByteOrder.LITTLE_ENDIAN)));
      } catch (IllegalArgumentException e) {
        return Optional.empty();
      }
    }

    @Override
    public void unreadable(String reason, long receivedNanos) {
      asked.listener().unreadable(reason, arrival(packed, ByteBuffer.allocate(0), receivedNanos));
    }
  }

  /** Why nothing comes, empty where nothing is known to be wrong. */
  synchronized String failure() {
    return failure;
  }

  @Override
  public synchronized int publishers() {
    return subscription.isPresent() ? 1 : 0;
  }

  @Override
  public synchronized Lost lost() {
    dropped += subscription.map(ArrivalSubscription::dropped).orElse(0L);
    return asked.most() == 1 || dropped == 0 ? Lost.NONE
        : new Lost(dropped, asked.topic() + ": more came than could be taken");
  }

  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      subscription.ifPresent(ArrivalSubscription::close);
      subscription = Optional.empty();
    }
    end.accept(this);
  }
}
