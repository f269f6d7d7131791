package org.robotui.rfic.recording.internal.session;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.robotui.data.Conflation;
import org.robotui.data.DataType;
import org.robotui.message.data.Adapter;
import org.robotui.message.data.Adapters;
import org.robotui.message.data.MessageForm;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.message.payload.ReceptionRule;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.recording.RecordedMessage;

/**
 * A topic that somebody wants, from all channels that carry it.
 *
 * @param <M> the Java value of a message
 */
final class Reception<M> implements TopicSubscription {
  /** What of the past holds at a time; later ones are more. */
  enum Past {
    /** What happened is over. */
    NOTHING,
    /** The last message. */
    LAST,
    /** Messages add to each other: the last ones, for some time back. */
    LATELY,
    /** Each holds for good. */
    ALL
  }

  private record Read<M>(PlayedChannel channel, PayloadFormat.Reading<M> reading) {}

  private final String topic;
  private final Past past;
  private final String file;
  private final String port;
  private final TopicListener<M> listener;
  private final Consumer<Reception<M>> end;
  private final Map<Integer, Read<M>> channels = new HashMap<>();
  private final String failure;

  Reception(ReceptionRule<M> rule, TopicTable table, String file, String port, TopicListener<M> listener,
      Consumer<Reception<M>> end) {
    this.topic = rule.topic();
    this.file = file;
    this.port = port;
    this.listener = listener;
    this.end = end;
    String reason = "";
    for (PlayedChannel each : table.all().filter(c -> rule.takes(c.topic(), c.format())).toList()) {
      try {
        channels.put(each.channel().id(), new Read<>(each, rule.reading(each.format())));
      } catch (IllegalArgumentException e) {
        reason = topic + ": " + e.getMessage();
      }
    }
    this.failure = reason;
    this.past = past(rule);
  }

  private static Past past(ReceptionRule<?> rule) {
    if (rule.form() instanceof MessageForm.Bound<?> bound && bound.type() == TFMessage.class) {
      return rule.topic().endsWith("_static") ? Past.ALL : Past.LATELY;
    }
    Adapters adapters = new Adapters();
    Adapter<?, ?> adapter =
        rule.form() instanceof MessageForm.ByFields ? adapters.ofFields(rule.type()) : adapters.of(rule.type());
    if (!adapter.form().equals(rule.form())) {
      return Past.LAST;
    }
    Conflation conflation = DataType.of(adapter.data()).conflation();
    return switch (conflation) {
      case SAMPLE -> Past.LAST;
      case KEYED -> Past.LATELY;
      case EVENT -> Past.NOTHING;
    };
  }

  String topic() {
    return topic;
  }

  /** The stream to which it goes. */
  String port() {
    return port;
  }

  Past past() {
    return past;
  }

  /** The channels that carry it. */
  List<PlayedChannel> channels() {
    return channels.values().stream().map(Read::channel).toList();
  }

  boolean has(int channel) {
    return channels.containsKey(channel);
  }

  /** Why nothing comes, empty where nothing is known to be wrong. */
  String failure() {
    return failure;
  }

  /** Gives a message of one of its channels to who wants it. */
  void deliver(RecordedMessage recorded, long receivedNanos) {
    Read<M> read = channels.get(recorded.channel().id());
    Arrival arrival = new Arrival(read.channel().sender(file), receivedNanos, read.channel().channel().isLatched(),
        recorded.channel().messageEncoding(), recorded.data().asReadOnlyBuffer(),
        read.channel().format()::record, recorded.channel().topic(), read.channel()::recordedDefinition);
    M message;
    try {
      message = read.reading().read(recorded.data().duplicate());
    } catch (IllegalArgumentException e) {
      listener.unreadable(String.valueOf(e.getMessage()), arrival);
      return;
    }
    listener.received(message, arrival);
  }

  @Override
  public int publishers() {
    return channels.size();
  }

  @Override
  public Lost lost() {
    return Lost.NONE;
  }

  @Override
  public void close() {
    end.accept(this);
  }

  /** A message that keeps nothing of the file in memory. */
  static RecordedMessage copied(RecordedMessage message) {
    ByteBuffer copy = ByteBuffer.allocate(message.data().remaining());
    copy.put(message.data().duplicate()).flip();
    return new RecordedMessage(message.channel(), message.logTime(), message.publishTime(), message.sequence(),
        copy.asReadOnlyBuffer());
  }
}
