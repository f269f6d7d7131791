package org.robotui.message.payload;

import org.robotui.message.DefinitionException;
import org.robotui.message.Encoding;
import org.robotui.message.Generation;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.payload.protobuf.DescriptorSet;
import org.robotui.message.payload.protobuf.ProtobufFormat;

/**
 * Finds out how messages are read, by what a server or a recording says of them. Where it has no definition of a type
 * of ROS, the one that is known here is taken; files may be read for that. Safe for all threads.
 */
public final class PayloadFormats {
  private static final String IDL = "ros2idl";
  private static final String JSON_SCHEMA = "jsonschema";

  private final RosDefinitions definitions;

  /**
   * Finds out.
   *
   * @param definitions knows types of ROS
   */
  public PayloadFormats(RosDefinitions definitions) {
    this.definitions = definitions;
  }

  /**
   * What is known of types of ROS.
   *
   * @return knows their definitions
   */
  public RosDefinitions definitions() {
    return definitions;
  }

  /**
   * How messages are read and written.
   *
   * @param source what is said of them
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
      return switch (definitions.of(source.type(), generation)) {
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
    boolean described = source.schemaEncoding().isEmpty() || source.schemaEncoding().equals(JSON_SCHEMA);
    return JsonFormat.of(source.type(), definitions, described ? source.schema() : "");
  }
}
