package org.robotui.message.payload.protobuf;

import com.google.protobuf.ByteString;
import com.google.protobuf.Descriptors.EnumValueDescriptor;
import com.google.protobuf.Descriptors.FieldDescriptor;
import com.google.protobuf.Message;
import java.util.List;
import java.util.Optional;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.FieldValue;
import org.robotui.message.data.ByteFields;

/**
 * A message as a record. Times and durations of Protocol Buffers are times here; a message that is not set has no
 * value.
 *
 * @param message the message
 */
public record ProtobufRecord(Message message) implements ByteFields {
  private static final long SECOND = 1_000_000_000L;
  private static final long MOST_SECONDS = Long.MAX_VALUE / SECOND - 2;

  @Override
  public String schema() {
    return message.getDescriptorForType().getFullName();
  }

  @Override
  public List<String> fields() {
    return message.getDescriptorForType().getFields().stream().map(FieldDescriptor::getName).toList();
  }

  @Override
  public Optional<FieldValue> field(String name) {
    return described(name).map(field -> field.isRepeated() ? many(field) : value(field, message.getField(field)));
  }

  @Override
  public Optional<Bytes> bytes(String name) {
    return described(name).map(message::getField).filter(ByteString.class::isInstance)
        .map(value -> Bytes.wrap(((ByteString) value).asReadOnlyByteBuffer()));
  }

  private Optional<FieldDescriptor> described(String name) {
    return Optional.ofNullable(message.getDescriptorForType().findFieldByName(name))
        .filter(field -> field.isRepeated() || !field.hasPresence() || message.hasField(field)
            || field.getJavaType() != FieldDescriptor.JavaType.MESSAGE && field.getContainingOneof() == null);
  }

  private FieldValue many(FieldDescriptor field) {
    List<?> values = (List<?>) message.getField(field);
    return switch (field.getJavaType()) {
      case INT, LONG, FLOAT, DOUBLE -> {
        double[] numbers = new double[values.size()];
        for (int i = 0; i < numbers.length; i++) {
          numbers[i] = number(field, (Number) values.get(i)).value();
        }
        yield new FieldValue.Numbers(Doubles.wrap(numbers));
      }
      default -> new FieldValue.Items(values.stream().map(each -> value(field, each)).toList());
    };
  }

  private static FieldValue value(FieldDescriptor field, Object value) {
    return switch (value) {
      case Boolean flag -> new FieldValue.Flag(flag);
      case Number number -> number(field, number);
      case ByteString bytes -> new FieldValue.Numbers(unsigned(bytes));
      case EnumValueDescriptor word -> new FieldValue.Text(word.getName());
      case Message inner -> nested(inner);
      default -> new FieldValue.Text(value.toString());
    };
  }

  private static FieldValue.Num number(FieldDescriptor field, Number value) {
    return switch (field.getType()) {
      case UINT32, FIXED32 -> {
        long whole = Integer.toUnsignedLong(value.intValue());
        yield new FieldValue.Num(whole, Long.toString(whole));
      }
      case UINT64, FIXED64 -> {
        String digits = Long.toUnsignedString(value.longValue());
        yield new FieldValue.Num(Double.parseDouble(digits), digits);
      }
      default -> new FieldValue.Num(value.doubleValue(), value.toString());
    };
  }

  private static FieldValue nested(Message inner) {
    String type = inner.getDescriptorForType().getFullName();
    return type.equals("google.protobuf.Timestamp") || type.equals("google.protobuf.Duration")
        ? new FieldValue.Time(nanos(inner))
        : new FieldValue.Nested(new ProtobufRecord(inner));
  }

  private static long nanos(Message time) {
    ProtobufRecord parts = new ProtobufRecord(time);
    return Math.clamp(parts.whole("seconds"), -MOST_SECONDS, MOST_SECONDS) * SECOND
        + Math.clamp(parts.whole("nanos"), -SECOND, SECOND);
  }

  private long whole(String name) {
    return field(name).filter(FieldValue.Num.class::isInstance).map(v -> (long) ((FieldValue.Num) v).value())
        .orElse(0L);
  }

  private static Doubles unsigned(ByteString bytes) {
    double[] values = new double[bytes.size()];
    for (int i = 0; i < values.length; i++) {
      values[i] = Byte.toUnsignedInt(bytes.byteAt(i));
    }
    return Doubles.wrap(values);
  }
}
