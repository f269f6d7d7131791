package org.robotui.message.payload;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.RecordShape;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Encoding;
import org.robotui.message.MessageSchema;
import org.robotui.message.data.MessageForm;
import org.robotui.message.data.MessageRecord;
import org.robotui.message.data.MessageShapes;
import org.robotui.web.tree.JsonText;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/**
 * Messages in JSON. Those of types of ROS are read by their definitions, others by the names of their fields.
 *
 * @param type the name of their type
 * @param definition of ROS, where the type is one of ROS
 * @param schema the form of the records, where it is known
 */
public record JsonFormat(String type, Optional<MessageSchema> definition, Optional<RecordShape> schema)
    implements PayloadFormat {
  private static final String WHOLE = "value";

  /**
   * Of a type as a server names it.
   *
   * @param type its name, may be empty
   * @param definitions knows the types of ROS
   * @param schema in JSON Schema, or empty
   * @return the format; by the definition of ROS where the type is one that is known here
   */
  public static JsonFormat of(String type, RosDefinitions definitions, String schema) {
    Optional<MessageSchema> known = type.contains("/") ? definitions.find(type) : Optional.empty();
    String name = known.map(ros -> ros.definition().type()).orElse(type.isEmpty() ? "json" : type);
    return new JsonFormat(name, known, JsonShapes.of(name, schema));
  }

  @Override
  public Optional<RecordShape> shape() {
    return definition.map(MessageShapes::of).or(() -> schema);
  }

  @Override
  public <M> Reading<M> reading(MessageForm<M> form) {
    return definition.isPresent() ? defined(definition.get(), form) : byFields(form);
  }

  @SuppressWarnings("unchecked") // the messages of each form are of its own type
  private static <M> Reading<M> defined(MessageSchema ros, MessageForm<M> form) {
    return switch (form) {
      case MessageForm.Bound<?> bound -> (Reading<M>) bound(bound.type(), ros);
      case MessageForm.Dynamic any -> payload -> (M) message(ros, payload);
      case MessageForm.ByFields any -> payload -> (M) new MessageRecord(message(ros, payload));
    };
  }

  private static <R extends Record> Reading<R> bound(Class<R> type, MessageSchema ros) {
    Reading<R> reading = RosFormat.bound(type, ros, Encoding.ROS1);
    return payload -> reading.read(message(ros, payload).bytes());
  }

  private static DynamicMessage message(MessageSchema ros, ByteBuffer payload) {
    return message(ros, members(payload));
  }

  /**
   * A tree as a message of ROS.
   *
   * @param ros the definition of its type
   * @param members the tree
   * @return the message
   * @throws IllegalArgumentException where the tree is no such message
   */
  public static DynamicMessage message(MessageSchema ros, Map<String, Object> members) {
    return RosFormat.built(ros, JsonValues.plain(members));
  }

  @SuppressWarnings("unchecked") // likewise
  private <M> Reading<M> byFields(MessageForm<M> form) {
    if (!(form instanceof MessageForm.ByFields)) {
      throw new IllegalArgumentException("messages in JSON have no definition of " + type);
    }
    return payload -> (M) new JsonRecord(type, members(payload));
  }

  /** What is no object becomes the only member of one. */
  private static Map<String, Object> members(ByteBuffer payload) {
    byte[] bytes = new byte[payload.remaining()];
    payload.duplicate().get(bytes);
    try {
      Object tree = JsonText.read(bytes);
      return tree instanceof Map<?, ?> ? Trees.object(tree) : Map.of(WHOLE, tree);
    } catch (TreeException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  @Override
  public ByteBuffer write(Map<String, Object> fields) {
    return text(fields);
  }

  static ByteBuffer text(Map<String, Object> fields) {
    return ByteBuffer.wrap(JsonText.write(fields).getBytes(StandardCharsets.UTF_8));
  }
}
