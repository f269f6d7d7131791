package org.robotui.message;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Objects;

/** A codec for one type that is known by its definition. */
public final class DynamicCodec implements MessageCodec<DynamicMessage> {

  private final MessageSchema schema;

  /**
   * Creates the codec of a type.
   *
   * @param schema the type
   */
  public DynamicCodec(MessageSchema schema) {
    this.schema = Objects.requireNonNull(schema, "schema");
  }

  @Override
  public MessageInfo info() {
    return schema.info();
  }

  @Override
  public DynamicMessage decode(ByteBuffer in) throws MessageException {
    return DynamicMessage.check(schema.layout(), in);
  }

  /**
   * {@inheritDoc}
   *
   * @throws IllegalArgumentException if the message has another type
   */
  @Override
  public void encode(DynamicMessage value, MessageWriter out) {
    if (!value.type().equals(schema.definition().type())) {
      throw new IllegalArgumentException("expected " + schema.definition().type() + ", got " + value.type());
    }
    out.bytes(value.bytes());
  }

  /**
   * Makes a message from Java values, as a form or a script gives them.
   *
   * @param values by field name: {@link Boolean}, {@link Number}, {@link String} (also for numbers), nanoseconds or a
   * map of {@code secs} and {@code nsecs} (or as ROS 2 and Foxglove write them) for times, a text in Base64 for bytes,
   * maps or {@link DynamicMessage} for messages, lists or primitive arrays or {@link PrimitiveArray} for arrays,
   * {@link RosValue} for any. Fields without a value become zero or empty
   * @return the message
   * @throws MessageException if a value does not fit its field or there is no such field
   */
  public DynamicMessage build(Map<String, ?> values) throws MessageException {
    MessageWriter out = new MessageWriter();
    new TreeEncoder(out).message(schema.layout(), values);
    return DynamicMessage.check(schema.layout(), ByteBuffer.wrap(out.toByteArray()));
  }
}
