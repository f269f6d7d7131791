package org.robotui.message.payload;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Encoding;
import org.robotui.message.Generation;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;
import org.robotui.message.RecordBinding;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.MessageRecord;

/**
 * How messages to a server are written: in the first of CDR, the encoding of ROS 1 and JSON that it takes.
 *
 * @param encoding the name by which the server knows it
 * @param generation whose definitions its messages have
 * @param definitions knows the definitions
 */
public record CommandFormat(String encoding, Generation generation, RosDefinitions definitions) {
  private static final String JSON = "json";

  /**
   * Chooses.
   *
   * @param encodings those that the server takes
   * @param threeParts whether its types of ROS have names of three parts, as in ROS 2
   * @param definitions knows definitions
   * @return none where the server takes none of them
   */
  public static Optional<CommandFormat> of(List<String> encodings, boolean threeParts,
      RosDefinitions definitions) {
    Generation json = threeParts ? Generation.ROS2 : Generation.ROS1;
    return List.of(new CommandFormat("cdr", Generation.ROS2, definitions),
        new CommandFormat("ros1", Generation.ROS1, definitions), new CommandFormat(JSON, json, definitions)).stream()
        .filter(each -> encodings.contains(each.encoding())).findFirst();
  }

  /**
   * The name of a type as the server has it.
   *
   * @param type a name of two parts
   * @return of as many parts as its generation writes
   */
  public String typeName(String type) {
    return generation == Generation.ROS2 ? type.replaceFirst("/", "/msg/") : type;
  }

  /**
   * How the definition of a type is written.
   *
   * @return empty where none is said
   */
  public String schemaEncoding() {
    return encoding.equals(JSON) ? "" : generation == Generation.ROS2 ? "ros2msg" : "ros1msg";
  }

  /**
   * The definition of a type.
   *
   * @param type a name of two parts
   * @return empty where none is said, or it is not known here
   */
  public String schema(String type) {
    return !encoding.equals(JSON) && definition(type) instanceof SchemaLookup.Found<MessageSchema> found
        ? found.schema().info().definition()
        : "";
  }

  /**
   * The definition by which messages of a type are made.
   *
   * @param type a name of two parts
   * @return the definition, or why there is none
   */
  public SchemaLookup<MessageSchema> definition(String type) {
    return definitions.of(type, generation);
  }

  /**
   * What writes the messages that a record holds.
   *
   * @param form the record
   * @param type its type
   * @param <M> the record
   * @return writes them
   * @throws IllegalArgumentException where the type is not known here
   */
  public <M extends Record> Writing<M> writing(Class<M> form, String type) {
    RecordBinding<M> binding = RecordBinding.shipped(form, generation);
    if (!encoding.equals(JSON)) {
      return binding::encode;
    }
    Function<M, Map<String, Object>> trees = trees(form, type);
    return message -> JsonFormat.text(trees.apply(message));
  }

  /**
   * What makes trees of JSON of the messages that a record holds.
   *
   * @param form the record
   * @param type its type
   * @param <M> the record
   * @return makes them
   * @throws IllegalArgumentException where the type is not known here
   */
  public <M extends Record> Function<M, Map<String, Object>> trees(Class<M> form, String type) {
    RecordBinding<M> binding = RecordBinding.shipped(form, generation);
    if (definition(type) instanceof SchemaLookup.Found<MessageSchema> found) {
      return message -> tree(read(found.schema(), binding.encode(message)));
    }
    throw new IllegalArgumentException("the definition of " + type + " is not known here");
  }

  /**
   * A message of any type as a tree of JSON.
   *
   * @param message the message
   * @return the tree, with times as the generation writes them
   */
  public Map<String, Object> tree(DynamicMessage message) {
    return JsonValues.tree(new MessageRecord(message), generation == Generation.ROS2 ? "nanosec" : "nsec");
  }

  private DynamicMessage read(MessageSchema schema, ByteBuffer bytes) {
    try {
      return DynamicMessage.read(schema, generation.encoding().reader(bytes));
    } catch (MessageException e) {
      throw new IllegalStateException("a message of ours cannot be read", e);
    }
  }

  /**
   * Writes a message of any type.
   *
   * @param message the message
   * @return its bytes
   */
  public ByteBuffer write(DynamicMessage message) {
    return encoding.equals(JSON) ? JsonFormat.text(tree(message))
        : RosFormat.write(message, generation == Generation.ROS2 ? Encoding.CDR : Encoding.ROS1);
  }

  /**
   * Writes messages.
   *
   * @param <M> the Java value of a message
   */
  @FunctionalInterface
  public interface Writing<M> {
    /**
     * Writes one.
     *
     * @param message the message
     * @return its bytes
     */
    ByteBuffer write(M message);
  }
}
