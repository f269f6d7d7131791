package org.robotui.message.topic;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.api.port.RawDefinition;
import org.robotui.data.array.Bytes;
import org.robotui.message.ConstantDefinition;
import org.robotui.message.Encoding;
import org.robotui.message.FieldDefinition;
import org.robotui.message.FieldType;
import org.robotui.message.MessageDefinition;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageSchema;
import org.robotui.message.Primitive;

/**
 * Definitions of messages of ROS as recordings hold them: with all that they refer to, in the language of the
 * generation by whose encoding the messages come. What is known here may have been read from the text of another one.
 */
public final class RecordedDefinitions {
  private static final String ROS1 = "ros1msg";
  private static final String ROS2 = "ros2msg";
  private static final String SEPARATOR = "=".repeat(80) + "\nMSG: ";
  private static final String BUILT_IN = "builtin_interfaces/";
  private static final String SECONDS = "\nint32 sec\nuint32 nanosec\n";

  private final boolean second;
  private final StringBuilder text = new StringBuilder();
  private boolean hasTime;
  private boolean hasDuration;

  private RecordedDefinitions(boolean second) {
    this.second = second;
  }

  /**
   * As a publisher of ROS 1 has announced it.
   *
   * @param announced with the full text; it is kept as it is
   * @return the definition, or none where the publisher gave no text
   */
  public static Optional<RawDefinition> announced(MessageInfo announced) {
    return announced.definition().isBlank() ? Optional.empty()
        : Optional.of(new RawDefinition(announced.type(), ROS1, utf8(announced.definition())));
  }

  /**
   * Written from what is known of a type.
   *
   * @param schema the type
   * @param encoding of its messages
   * @return the definition
   */
  public static RawDefinition of(MessageSchema schema, Encoding encoding) {
    RecordedDefinitions written = new RecordedDefinitions(encoding == Encoding.CDR);
    written.add(schema);
    String type = schema.definition().type();
    return written.second
        ? new RawDefinition(type.replaceFirst("/", "/msg/"), ROS2, utf8(written.text.toString()))
        : new RawDefinition(type, ROS1, utf8(written.text.toString()));
  }

  private static Bytes utf8(String text) {
    return Bytes.wrap(ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8)));
  }

  private void add(MessageSchema schema) {
    add(schema.definition());
    new TreeMap<>(schema.nested()).forEach((name, nested) -> {
      text.append(SEPARATOR).append(name).append('\n');
      add(nested);
    });
    if (hasTime) {
      text.append(SEPARATOR).append(BUILT_IN).append("Time").append(SECONDS);
    }
    if (hasDuration) {
      text.append(SEPARATOR).append(BUILT_IN).append("Duration").append(SECONDS);
    }
  }

  private void add(MessageDefinition definition) {
    for (ConstantDefinition constant : definition.constants()) {
      text.append(constant.type().rosName()).append(' ').append(constant.name()).append('=').append(constant.value())
          .append('\n');
    }
    for (FieldDefinition field : definition.fields()) {
      text.append(typeOf(field.type())).append(' ').append(field.name());
      field.initial().filter(value -> second).ifPresent(value -> text.append(' ').append(value));
      text.append('\n');
    }
  }

  private FieldType typeOf(FieldType type) {
    Optional<Primitive> time = type.primitive().filter(Primitive::isTemporal);
    if (!second || time.isEmpty()) {
      return second ? type : new FieldType(type.base(), type.arity(), type.length());
    }
    boolean point = time.get() == Primitive.TIME;
    hasTime |= point;
    hasDuration |= !point;
    return new FieldType(BUILT_IN + (point ? "Time" : "Duration"), type.arity(), type.length(), type.bound(), 0);
  }
}
