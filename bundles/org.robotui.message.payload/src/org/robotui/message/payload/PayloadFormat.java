package org.robotui.message.payload;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.RecordShape;
import org.robotui.message.MessageSchema;
import org.robotui.message.data.MessageForm;

/** How messages of one schema are read and written. Safe for all threads. */
public interface PayloadFormat {

  /**
   * The name of the type as all robot interfaces with topics know it: of two parts where it is one of ROS.
   *
   * @return the name
   */
  String type();

  /**
   * The definition of ROS by which the messages are read.
   *
   * @return none where something else defines them
   */
  default Optional<MessageSchema> definition() {
    return Optional.empty();
  }

  /**
   * Why no message can be read.
   *
   * @return a sentence, or none
   */
  default Optional<String> obstacle() {
    return Optional.empty();
  }

  /**
   * The form of its records.
   *
   * @return none where it is not known
   */
  Optional<RecordShape> shape();

  /**
   * What reads messages.
   *
   * @param form what they are read as
   * @param <M> the Java value of a message
   * @return reads them
   * @throws IllegalArgumentException where messages of this format cannot be read so; the message is for users
   */
  <M> Reading<M> reading(MessageForm<M> form);

  /**
   * A message by the names of its fields.
   *
   * @param payload the whole message
   * @return its fields
   * @throws IllegalArgumentException where it cannot be read
   */
  default DynamicRecord read(ByteBuffer payload) {
    return reading(new MessageForm.ByFields()).read(payload);
  }

  /**
   * A message by the names of its fields, where it can be read.
   *
   * @param bytes the whole message
   * @return its fields, or none where it cannot be read
   */
  default Optional<DynamicRecord> record(Bytes bytes) {
    try {
      return Optional.of(read(bytes.buffer(ByteOrder.LITTLE_ENDIAN)));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /**
   * Makes a message.
   *
   * @param fields by their names; those that are missing are zero or empty
   * @return the message
   * @throws IllegalArgumentException where it is not filled in like this
   */
  ByteBuffer write(Map<String, Object> fields);

  /**
   * Reads messages.
   *
   * @param <M> the Java value of a message
   */
  @FunctionalInterface
  interface Reading<M> {
    /**
     * Reads one.
     *
     * @param payload the whole message; nobody writes to it again
     * @return the message
     * @throws IllegalArgumentException where it cannot be read
     */
    M read(ByteBuffer payload);
  }
}
