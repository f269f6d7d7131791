package org.robotui.message.data;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.RecordShape;
import org.robotui.message.FieldDefinition;
import org.robotui.message.FieldType;
import org.robotui.message.MessageDefinition;
import org.robotui.message.MessageSchema;
import org.robotui.message.Primitive;

/** The forms of ROS messages. */
public final class MessageShapes {
  private static final int BYTE = 8;
  private static final int SHORT = 16;
  private static final int WORD = 32;
  private static final int LONG = 64;

  private final MessageSchema schema;
  private final Deque<String> within = new ArrayDeque<>();

  private MessageShapes(MessageSchema schema) {
    this.schema = schema;
  }

  /**
   * The form of a message.
   *
   * @param schema its definition and those that it needs
   * @return its form
   */
  public static RecordShape of(MessageSchema schema) {
    return new MessageShapes(schema).record(schema.definition());
  }

  private RecordShape record(MessageDefinition definition) {
    List<RecordShape.Field> fields =
        definition.fields().stream().map(f -> new RecordShape.Field(f.name(), field(f))).toList();
    List<RecordShape.Constant> constants = definition.constants().stream()
        .map(c -> new RecordShape.Constant(c.name(), c.value())).toList();
    return new RecordShape(definition.type(), fields, constants);
  }

  private FieldShape field(FieldDefinition field) {
    FieldType type = field.type();
    FieldShape one = type.primitive().map(MessageShapes::primitive).orElseGet(() -> nested(type.base()));
    return switch (type.arity()) {
      case ONE -> one;
      case FIXED -> new FieldShape.Many(one, type.length());
      case VARIABLE -> new FieldShape.Many(one, 0);
    };
  }

  /**
   * Definitions that contain themselves cannot be sent; they are refused when parsed, and cut off here all the same.
   */
  private FieldShape nested(String type) {
    Optional<MessageDefinition> inner =
        Optional.ofNullable(schema.nested().get(type)).filter(d -> !within.contains(type));
    within.push(type);
    FieldShape shape = new FieldShape.Nested(
        inner.map(this::record).orElseGet(() -> new RecordShape(type, List.of(), List.of())));
    within.pop();
    return shape;
  }

  private static FieldShape primitive(Primitive primitive) {
    return switch (primitive) {
      case BOOL -> new FieldShape.Flag();
      case INT8, BYTE -> new FieldShape.Whole(BYTE, true);
      case UINT8, CHAR -> new FieldShape.Whole(BYTE, false);
      case INT16 -> new FieldShape.Whole(SHORT, true);
      case UINT16 -> new FieldShape.Whole(SHORT, false);
      case INT32 -> new FieldShape.Whole(WORD, true);
      case UINT32 -> new FieldShape.Whole(WORD, false);
      case INT64 -> new FieldShape.Whole(LONG, true);
      case UINT64 -> new FieldShape.Whole(LONG, false);
      case FLOAT32 -> new FieldShape.Real(WORD);
      case FLOAT64 -> new FieldShape.Real(LONG);
      case STRING, WSTRING -> new FieldShape.Text();
      case TIME -> new FieldShape.Time();
      case DURATION -> new FieldShape.Duration();
    };
  }
}
