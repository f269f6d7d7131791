package org.robotui.message.topic;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.robotui.api.port.RawDefinition;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.RawOrigin;
import org.robotui.data.Data;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;

/**
 * How a message came.
 *
 * @param sender who published it, as a user knows it
 * @param receiveNanos when its last byte was read, by {@link System#nanoTime()}
 * @param kept whether the publisher keeps its last message for those who come later
 * @param encoding the name of the encoding of its bytes, as in {@link org.robotui.api.port.RawMessage}
 * @param bytes the whole message, read only
 * @param reading reads such bytes as a record of the message's own fields; none where they cannot be read
 * @param topic the robot's name of the topic that it came by, which may be another one than what was subscribed; empty
 * where it came by none
 * @param definition of its type, where that is known; see {@link RawOrigin}
 */
public record Arrival(String sender, long receiveNanos, boolean kept, String encoding, ByteBuffer bytes,
    Function<Bytes, Optional<DynamicRecord>> reading, String topic, Supplier<Optional<RawDefinition>> definition) {

  /**
   * A message of a type whose definition is not known, which came by no topic.
   *
   * @param sender who published it
   * @param receiveNanos when its last byte was read
   * @param kept whether the publisher keeps its last message
   * @param encoding the name of the encoding
   * @param bytes the whole message
   * @param reading reads such bytes
   */
  public Arrival(String sender, long receiveNanos, boolean kept, String encoding, ByteBuffer bytes,
      Function<Bytes, Optional<DynamicRecord>> reading) {
    this(sender, receiveNanos, kept, encoding, bytes, reading, "", Optional::empty);
  }

  /**
   * The message as those get it who keep it, read only when its fields are asked for.
   *
   * @param type the robot's name of its type
   * @param value what was made of it
   * @return the message
   */
  public RawMessage raw(String type, Data value) {
    return raw(type,
        bytes -> value instanceof DynamicRecord record ? Optional.of(record) : reading.apply(bytes));
  }

  /**
   * The message as those get it who keep it.
   *
   * @param type the robot's name of its type
   * @param reader reads it
   * @return the message
   */
  public RawMessage raw(String type, RawMessage.Reader reader) {
    return new RawMessage(type, encoding, Bytes.wrap(bytes), reader, new RawOrigin(topic, sender, kept, definition));
  }
}
