package org.robotui.rfic.foxglove.internal.payload;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.message.DefinitionException;
import org.robotui.message.Encoding;
import org.robotui.message.Generation;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageRegistry;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.rfic.foxglove.internal.protobuf.DescriptorSet;

/**
 * Finds out how messages are read, by what a server says of them. Where it sends no definition of a type of ROS, the
 * one that is known here is taken; files may be read for that. Safe for all threads.
 */
public final class PayloadFormats {
  private static final String IDL = "ros2idl";
  private static final String JSON_SCHEMA = "jsonschema";

  private final Map<Generation, MessageRegistry> registries;

  /**
   * Knows the types that are shipped and those of this machine.
   *
   * @param environment the environment variables
   */
  public PayloadFormats(Map<String, String> environment) {
    this.registries = Map.of(
        Generation.ROS1, new MessageRegistry(LocalDefinitions.fromEnvironment(environment), Generation.ROS1),
        Generation.ROS2, new MessageRegistry(LocalDefinitions.ofRos2(List.of(), environment), Generation.ROS2));
  }

  /**
   * How messages are read and written.
   *
   * @param source what a server says of them
   * @return the format; one that says why where they cannot be read
   */
  public PayloadFormat of(PayloadSource source) {
    try {
      return switch (source.encoding()) {
        case "ros1" -> ros(source, Generation.ROS1, Encoding.ROS1);
        case "cdr" -> ros(source, Generation.ROS2, Encoding.CDR);
        case "json" -> json(source);
        case "protobuf" -> new ProtobufFormat(DescriptorSet.message(source.schema(), source.type()));
        default -> unknown(source, "this encoding is none that is known here (ros1, cdr, json, protobuf)");
      };
    } catch (DefinitionException | IllegalArgumentException e) {
      return unknown(source, e.getMessage());
    }
  }

  private static PayloadFormat unknown(PayloadSource source, String reason) {
    return new UnknownFormat(source.type().isEmpty() ? source.encoding() : source.type(),
        source.words() + ": " + reason);
  }

  private PayloadFormat ros(PayloadSource source, Generation generation, Encoding encoding)
      throws DefinitionException {
    if (source.schema().isBlank()) {
      // also the text of a type without fields is empty
      return switch (definition(source.type(), generation)) {
        case SchemaLookup.Found<MessageSchema> found -> new RosFormat(found.schema(), encoding);
        case SchemaLookup.Missing<MessageSchema> missing -> source.schemaEncoding().isEmpty()
            ? unknown(source, missing.reason())
            : new RosFormat(MessageSchema.parse(source.type(), "", generation), encoding);
      };
    }
    return new RosFormat(source.schemaEncoding().equals(IDL) ? MessageSchema.parseIdl(source.type(), source.schema())
        : MessageSchema.parse(source.type(), source.schema(), generation), encoding);
  }

  private PayloadFormat json(PayloadSource source) {
    boolean three = source.type().indexOf('/') != source.type().lastIndexOf('/');
    Generation first = three ? Generation.ROS2 : Generation.ROS1;
    Optional<MessageSchema> known = source.type().contains("/")
        ? found(source.type(), first).or(() -> found(source.type(), three ? Generation.ROS1 : Generation.ROS2))
        : Optional.empty();
    String type = known.map(schema -> schema.definition().type())
        .orElse(source.type().isEmpty() ? source.encoding() : source.type());
    boolean described = source.schemaEncoding().isEmpty() || source.schemaEncoding().equals(JSON_SCHEMA);
    return new JsonFormat(type, known, described ? JsonShapes.of(type, source.schema()) : Optional.empty());
  }

  private Optional<MessageSchema> found(String type, Generation generation) {
    return definition(type, generation) instanceof SchemaLookup.Found<MessageSchema> found
        ? Optional.of(found.schema())
        : Optional.empty();
  }

  /**
   * A definition that is known here.
   *
   * @param type a type of ROS
   * @param generation whose version of it
   * @return the definition, or why there is none
   */
  public SchemaLookup<MessageSchema> definition(String type, Generation generation) {
    return registries.get(generation).message(type);
  }
}
