package org.robotui.rfic.recording.internal.lines;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.message.Generation;
import org.robotui.message.MessageInfo;
import org.robotui.message.RecordBinding;
import org.robotui.message.RecordCodec;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordedSchema;
import org.robotui.web.tree.JsonText;

/**
 * Makes messages of what lines say: those of ROS 1 where it has a type for them, so that they are shown as those of any
 * robot and read by the programs of others, else JSON.
 */
final class LineChannels {
  private static final int MOST = 1000;

  private final Map<String, RecordedChannel> byTopic = new LinkedHashMap<>();
  private final Map<Class<?>, RecordBinding<?>> bindings = new HashMap<>();

  /**
   * When something was.
   *
   * @param logged when it was written, nanoseconds since 1970
   * @param stamp when it was measured
   */
  record Moment(long logged, long stamp) {}

  synchronized <M extends Record> RecordedMessage ros(String topic, Class<M> type, M value, Moment moment) {
    RecordedChannel channel = byTopic.computeIfAbsent(topic, name -> rosChannel(name, RecordCodec.of(type).info()));
    return message(channel, binding(type).encode(value), moment);
  }

  private RecordedChannel rosChannel(String topic, MessageInfo info) {
    return channel(topic, "ros1",
        new RecordedSchema(info.type(), "ros1msg", info.definition().getBytes(StandardCharsets.UTF_8)),
        Map.of("md5sum", info.md5()));
  }

  private RecordedChannel channel(String topic, String encoding, RecordedSchema schema, Map<String, String> metadata) {
    if (byTopic.size() >= MOST) {
      throw new IllegalArgumentException("it is of the " + (MOST + 1) + "th kind, more than are read");
    }
    return new RecordedChannel(byTopic.size() + 1, topic, encoding, schema, metadata);
  }

  synchronized RecordedMessage json(String topic, String type, Map<String, Object> values, Moment moment) {
    RecordedChannel channel = byTopic.computeIfAbsent(topic,
        name -> channel(name, "json", new RecordedSchema(type, "", new byte[0]), Map.of()));
    return message(channel, ByteBuffer.wrap(JsonText.write(values).getBytes(StandardCharsets.UTF_8)), moment);
  }

  /** Bytes of a framework as they are; topics may have several types. */
  synchronized RecordedMessage raw(String topic, RecordedSchema schema, String encoding, Map<String, String> metadata,
      ByteBuffer bytes, Moment moment) {
    RecordedChannel channel = byTopic.computeIfAbsent(topic + " " + schema.name() + " " + metadata,
        name -> channel(topic, encoding, schema, metadata));
    return message(channel, bytes, moment);
  }

  private static RecordedMessage message(RecordedChannel channel, ByteBuffer bytes, Moment moment) {
    return new RecordedMessage(channel, moment.logged(), moment.stamp(), 0, bytes.asReadOnlyBuffer());
  }

  @SuppressWarnings("unchecked") // each binding is of its own type
  private <M extends Record> RecordBinding<M> binding(Class<M> type) {
    return (RecordBinding<M>) bindings.computeIfAbsent(type,
        each -> RecordBinding.shipped(each.asSubclass(Record.class), Generation.ROS1));
  }

  synchronized List<RecordedChannel> all() {
    return List.copyOf(byTopic.values());
  }
}
