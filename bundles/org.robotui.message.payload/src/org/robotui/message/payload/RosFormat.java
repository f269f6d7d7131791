package org.robotui.message.payload;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.RecordShape;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Encoding;
import org.robotui.message.FieldWriter;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;
import org.robotui.message.RecordBinding;
import org.robotui.message.data.MessageForm;
import org.robotui.message.data.MessageRecord;
import org.robotui.message.data.MessageShapes;

/**
 * Messages of ROS.
 *
 * @param schema their definition
 * @param encoding how their fields become bytes
 */
public record RosFormat(MessageSchema schema, Encoding encoding) implements PayloadFormat {
  @Override
  public String type() {
    return schema.definition().type();
  }

  @Override
  public Optional<MessageSchema> definition() {
    return Optional.of(schema);
  }

  @Override
  public Optional<RecordShape> shape() {
    return Optional.of(MessageShapes.of(schema));
  }

  @Override
  @SuppressWarnings("unchecked") // the messages of each form are of its own type
  public <M> Reading<M> reading(MessageForm<M> form) {
    return switch (form) {
      case MessageForm.Bound<?> bound -> (Reading<M>) bound(bound.type(), schema, encoding);
      case MessageForm.Dynamic any -> (Reading<M>) (Reading<DynamicMessage>) this::message;
      case MessageForm.ByFields any -> payload -> (M) new MessageRecord(message(payload));
    };
  }

  /** Reads messages as a record, also of another version of its type. */
  static <R extends Record> Reading<R> bound(Class<R> type, MessageSchema schema, Encoding encoding) {
    RecordBinding<R> binding = RecordBinding.shipped(type, schema, encoding);
    return payload -> {
      try {
        return binding.decode(payload);
      } catch (MessageException e) {
        throw new IllegalArgumentException(e.getMessage(), e);
      }
    };
  }

  /** Reads a message of any type. */
  private DynamicMessage message(ByteBuffer payload) {
    try {
      return DynamicMessage.read(schema, encoding.reader(payload));
    } catch (MessageException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  @Override
  public ByteBuffer write(Map<String, Object> fields) {
    return write(built(schema, fields), encoding);
  }

  static DynamicMessage built(MessageSchema schema, Map<String, Object> fields) {
    try {
      return new DynamicCodec(schema).build(fields);
    } catch (MessageException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  static ByteBuffer write(DynamicMessage message, Encoding encoding) {
    FieldWriter out = encoding.writer();
    message.write(out);
    return out.view();
  }
}
