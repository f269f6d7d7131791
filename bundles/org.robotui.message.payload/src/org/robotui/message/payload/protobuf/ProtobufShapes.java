package org.robotui.message.payload.protobuf;

import com.google.protobuf.Descriptors.Descriptor;
import com.google.protobuf.Descriptors.FieldDescriptor;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.RecordShape;

/** The forms of messages. One that contains itself is cut off there. */
public final class ProtobufShapes {
  private static final int WORD = 32;
  private static final int LONG = 64;
  private static final int DEEPEST = 16;

  private final Deque<Descriptor> within = new ArrayDeque<>();

  private ProtobufShapes() {}

  /**
   * The form of a message.
   *
   * @param type its type
   * @return its form
   */
  public static RecordShape of(Descriptor type) {
    return new ProtobufShapes().record(type);
  }

  private RecordShape record(Descriptor type) {
    if (within.contains(type) || within.size() > DEEPEST) {
      return new RecordShape(type.getFullName(), List.of(), List.of());
    }
    within.push(type);
    List<RecordShape.Field> fields =
        type.getFields().stream().map(field -> new RecordShape.Field(field.getName(), shape(field))).toList();
    within.pop();
    return new RecordShape(type.getFullName(), fields, List.of());
  }

  private FieldShape shape(FieldDescriptor field) {
    return field.isRepeated() ? new FieldShape.Many(one(field), 0) : one(field);
  }

  private FieldShape one(FieldDescriptor field) {
    return switch (field.getType()) {
      case BOOL -> new FieldShape.Flag();
      case INT32, SINT32, SFIXED32 -> new FieldShape.Whole(WORD, true);
      case UINT32, FIXED32 -> new FieldShape.Whole(WORD, false);
      case INT64, SINT64, SFIXED64 -> new FieldShape.Whole(LONG, true);
      case UINT64, FIXED64 -> new FieldShape.Whole(LONG, false);
      case FLOAT -> new FieldShape.Real(WORD);
      case DOUBLE -> new FieldShape.Real(LONG);
      case STRING, ENUM, BYTES -> new FieldShape.Text();
      case MESSAGE, GROUP -> switch (field.getMessageType().getFullName()) {
        case "google.protobuf.Timestamp" -> new FieldShape.Time();
        case "google.protobuf.Duration" -> new FieldShape.Duration();
        default -> new FieldShape.Nested(record(field.getMessageType()));
      };
    };
  }
}
