package org.robotui.rfic.gazebo.internal.session;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.port.RawDefinition;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.gazebo.GazeboNode;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.message.payload.protobuf.DescriptorSet;
import org.robotui.message.payload.protobuf.ProtobufFormat;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.web.ArrivalSubscription;

/**
 * A topic that is received, from all who publish it.
 *
 * @param <M> the Java value of a message
 */
final class GazeboReception<M> implements TopicSubscription {
  private static final String ENCODING = "protobuf";

  private final String topic;
  private final Read<M> read;
  private final Supplier<WorldTable> table;
  private final ArrivalSubscription subscription;
  private long dropped;

  /**
   * How messages are read.
   *
   * @param type of the messages
   * @param reading reads one
   * @param format reads one by the names of its fields
   * @param most how many wait
   * @param <M> the Java value of a message
   */
  record Read<M>(String type, PayloadFormat.Reading<M> reading, PayloadFormat format, int most) {}

  GazeboReception(GazeboNode node, String topic, Read<M> read, TopicListener<M> listener,
      Supplier<WorldTable> table) {
    this.topic = topic;
    this.read = read;
    this.table = table;
    this.subscription = node.subscribe(topic, read.type(), read.most(),
        (sender, payload, nanos) -> received(sender, payload, nanos, listener));
  }

  private void received(String sender, ByteBuffer payload, long nanos, TopicListener<M> listener) {
    Arrival arrival = arrival(topic, read.format(), sender, payload, nanos);
    M message;
    try {
      message = read.reading().read(payload);
    } catch (IllegalArgumentException e) {
      listener.unreadable(String.valueOf(e.getMessage()), arrival);
      return;
    }
    listener.received(message, arrival);
  }

  /** How a message came. */
  static Arrival arrival(String topic, PayloadFormat format, String sender, ByteBuffer payload, long nanos) {
    return new Arrival(sender, nanos, false, ENCODING, payload.asReadOnlyBuffer(), bytes -> record(format, bytes),
        topic, () -> definition(format));
  }

  private static Optional<RawDefinition> definition(PayloadFormat format) {
    return format instanceof ProtobufFormat known
        ? Optional.of(new RawDefinition(known.type(), ENCODING, Bytes.of(DescriptorSet.of(known.descriptor()))))
        : Optional.empty();
  }

  private static Optional<DynamicRecord> record(PayloadFormat format, Bytes bytes) {
    try {
      return Optional.of(format.read(bytes.buffer(ByteOrder.LITTLE_ENDIAN)));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  @Override
  public int publishers() {
    return (int) table.get().publishers(topic).stream().filter(each -> each.type().equals(read.type())).count();
  }

  /** Of what only the newest counts, nothing is lost where it gives way to a newer one. */
  @Override
  public synchronized Lost lost() {
    dropped += subscription.dropped();
    return read.most() == 1 || dropped == 0 ? Lost.NONE
        : new Lost(dropped, topic + ": more came than could be taken");
  }

  @Override
  public void close() {
    subscription.close();
  }
}
