package org.robotui.message.data;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.FieldDefinition;
import org.robotui.message.MessageDefinition;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;
import org.robotui.message.Primitive;
import org.robotui.message.RosValue;

/**
 * Records as messages of a type: each field takes what the record has by its name, at any depth, so that messages of
 * ROS 1 become messages of ROS 2 and back. Fields that only one side has are left out or zero, as the sequence number
 * of headers in ROS 1.
 */
public final class MessageByNames {
  private final MessageSchema schema;
  private final DynamicCodec codec;

  /**
   * For messages of a type.
   *
   * @param schema the type
   */
  public MessageByNames(MessageSchema schema) {
    this.schema = schema;
    this.codec = new DynamicCodec(schema);
  }

  /**
   * A record as a message.
   *
   * @param record its fields
   * @return the message
   * @throws IllegalArgumentException where a field does not hold what the record has by its name, or where no name is
   * the same; names what
   */
  public DynamicMessage of(DynamicRecord record) {
    MessageDefinition type = schema.definition();
    if (!type.fields().isEmpty() && type.fields().stream().noneMatch(f -> record.fields().contains(f.name()))) {
      throw new IllegalArgumentException(
          type.type() + " has no field in common with " + record.schema() + ", which has "
              + String.join(", ", record.fields()));
    }
    try {
      return codec.build(fields(record, type));
    } catch (MessageException e) {
      throw new IllegalArgumentException(type.type() + " cannot hold the " + record.schema() + ": " + e.getMessage(),
          e);
    }
  }

  private Map<String, Object> fields(DynamicRecord record, MessageDefinition type) {
    return record instanceof MessageRecord message
        ? filled(type, field -> message.message().field(field.name()).map(v -> value(v, field)))
        : filled(type, field -> bytes(record, field).or(() -> record.field(field.name()).map(v -> value(v, field))));
  }

  private static Map<String, Object> filled(MessageDefinition type,
      Function<FieldDefinition, Optional<Object>> values) {
    Map<String, Object> fields = new LinkedHashMap<>();
    type.fields().forEach(field -> values.apply(field).ifPresent(value -> fields.put(field.name(), value)));
    return fields;
  }

  private static Optional<Object> bytes(DynamicRecord record, FieldDefinition field) {
    return field.type().isArray() ? record.bytes(field.name()).map(bytes -> {
      byte[] array = new byte[bytes.size()];
      bytes.copyTo(0, array, 0, array.length);
      return array;
    }) : Optional.empty();
  }

  private Object value(RosValue value, FieldDefinition field) {
    return switch (value) {
      case RosValue.Nested n -> nested(new MessageRecord(n.value()), field);
      case RosValue.Messages m -> m.values().stream().map(each -> nested(new MessageRecord(each), field)).toList();
      default -> value;
    };
  }

  private Object value(FieldValue value, FieldDefinition field) {
    return switch (value) {
      case FieldValue.Flag f -> f.value();
      case FieldValue.Num n -> number(n);
      case FieldValue.Text t -> t.value();
      case FieldValue.Time t -> t.nanos();
      case FieldValue.Numbers n -> numbers(n.values(), field);
      case FieldValue.Items i -> i.values().stream().map(each -> value(each, field)).toList();
      case FieldValue.Nested n -> nested(n.value(), field);
    };
  }

  private Object nested(DynamicRecord record, FieldDefinition field) {
    MessageDefinition inner = schema.nested().get(field.type().base());
    if (inner == null) {
      throw new IllegalArgumentException(
          "'" + field.name() + "' is " + field.type() + ", and the other side has fields in it: "
              + String.join(", ", record.fields()));
    }
    return fields(record, inner);
  }

  /** Whole numbers stay whole, as a field may hold no others. */
  private static Object number(FieldValue.Num number) {
    try {
      return Long.parseLong(number.exact());
    } catch (NumberFormatException e) {
      double value = number.value();
      return value == Math.rint(value) && Math.abs(value) < 1L << 53 ? (Object) (long) value : value;
    }
  }

  private static Object numbers(Doubles values, FieldDefinition field) {
    Optional<Primitive> type = field.type().primitive();
    if (type.filter(Primitive::isFloating).isEmpty()) {
      return IntStream.range(0, values.size()).mapToLong(i -> (long) values.get(i)).toArray();
    }
    if (type.get() == Primitive.FLOAT32) {
      float[] floats = new float[values.size()];
      IntStream.range(0, floats.length).forEach(i -> floats[i] = (float) values.get(i));
      return floats;
    }
    return IntStream.range(0, values.size()).mapToDouble(values::get).toArray();
  }
}
