package org.robotui.message.payload.protobuf;

import com.google.protobuf.ByteString;
import com.google.protobuf.Descriptors.Descriptor;
import com.google.protobuf.Descriptors.EnumValueDescriptor;
import com.google.protobuf.Descriptors.FieldDescriptor;
import com.google.protobuf.DynamicMessage;
import java.lang.reflect.Array;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Makes messages of trees of Java values; errors name the field. */
final class ProtobufBuilder {
  private static final long SECOND = 1_000_000_000L;

  private ProtobufBuilder() {}

  static DynamicMessage message(Descriptor type, Map<?, ?> fields) {
    DynamicMessage.Builder message = DynamicMessage.newBuilder(type);
    fields.forEach((name, value) -> {
      FieldDescriptor field = Optional.ofNullable(type.findFieldByName(String.valueOf(name))).orElseThrow(
          () -> new IllegalArgumentException(type.getFullName() + " has no field '" + name + "'"));
      if (field.isRepeated()) {
        items(value).forEach(each -> message.addRepeatedField(field, one(field, each)));
      } else if (!isUnsaid(field, value)) {
        message.setField(field, one(field, value));
      }
    });
    return message.build();
  }

  /**
   * Forms give every field a value. Records and members of a union that are there mean something also where they are
   * zero, as a pose at which something is to be: those in which nothing was filled in are left out.
   */
  private static boolean isUnsaid(FieldDescriptor field, Object value) {
    return switch (field.getJavaType()) {
      case MESSAGE -> value instanceof Map<?, ?> inner && !inner.isEmpty() && isZero(inner);
      case ENUM -> isZero(value);
      default -> field.getRealContainingOneof() != null && isZero(value);
    };
  }

  private static boolean isZero(Object value) {
    return switch (value) {
      case String text -> text.isEmpty();
      case Number number -> number.doubleValue() == 0;
      case Boolean flag -> !flag;
      case Map<?, ?> inner -> inner.values().stream().allMatch(ProtobufBuilder::isZero);
      case List<?> list -> list.isEmpty();
      default -> false;
    };
  }

  private static List<Object> items(Object value) {
    if (value instanceof List<?> list) {
      return new ArrayList<>(list);
    }
    List<Object> items = new ArrayList<>();
    if (value.getClass().isArray()) {
      for (int i = 0; i < Array.getLength(value); i++) {
        items.add(Array.get(value, i));
      }
      return items;
    }
    throw new IllegalArgumentException("'" + value + "' is no list");
  }

  private static Object one(FieldDescriptor field, Object value) {
    try {
      return switch (field.getJavaType()) {
        case INT -> word(number(value).longValueExact());
        case LONG -> number(value).toBigIntegerExact().longValue();
        case FLOAT -> Float.valueOf(value.toString());
        case DOUBLE -> Double.valueOf(value.toString());
        case BOOLEAN -> value instanceof Boolean flag ? flag : Boolean.valueOf(value.toString());
        case STRING -> value.toString();
        case BYTE_STRING -> ByteString.copyFrom(Base64.getDecoder().decode(value.toString()));
        case ENUM -> word(field, value);
        case MESSAGE -> inner(field.getMessageType(), value);
      };
    } catch (NumberFormatException | ArithmeticException e) {
      throw new IllegalArgumentException(field.getName() + ": '" + value + "' is no "
          + field.getType().name().toLowerCase(Locale.ROOT), e);
    }
  }

  /** Numbers of 32 bits, with a sign or without. */
  private static int word(long number) {
    if (number != (int) number && number >>> Integer.SIZE != 0) {
      throw new ArithmeticException(number + " has more than 32 bits");
    }
    return (int) number;
  }

  private static BigDecimal number(Object value) {
    return new BigDecimal(value.toString().strip());
  }

  private static EnumValueDescriptor word(FieldDescriptor field, Object value) {
    Optional<EnumValueDescriptor> named = Optional.ofNullable(field.getEnumType().findValueByName(value.toString()));
    return named.or(() -> field.getEnumType().getValues().stream()
        .filter(each -> String.valueOf(each.getNumber()).equals(value.toString())).findFirst())
        .orElseThrow(() -> new IllegalArgumentException(field.getName() + ": there is no '" + value + "' in "
            + field.getEnumType().getFullName()));
  }

  /** Times may come in nanoseconds. */
  private static DynamicMessage inner(Descriptor type, Object value) {
    return switch (value) {
      case Map<?, ?> fields -> message(type, fields);
      case Number nanos -> message(type, Map.of("seconds", Math.floorDiv(nanos.longValue(), SECOND), "nanos",
          Math.floorMod(nanos.longValue(), SECOND)));
      default -> throw new IllegalArgumentException("'" + value + "' is no " + type.getFullName());
    };
  }
}
