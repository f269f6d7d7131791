package org.robotui.message;

import java.lang.reflect.Array;
import java.math.BigInteger;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Writes messages from trees of Java values, field by field. */
final class TreeEncoder {

  private static final int MAX_SIZE = 1 << 27;

  private final MessageWriter out;

  TreeEncoder(MessageWriter out) {
    this.out = out;
  }

  void message(Layout layout, Map<String, ?> values) throws MessageException {
    for (String name : values.keySet()) {
      if (layout.field(name).isEmpty()) {
        throw problem(layout.type() + " has no field '" + name + "'; it has " + names(layout));
      }
    }
    for (Layout.Field each : layout.fields()) {
      try {
        Object value = bytes(each, unwrap(values.get(each.name())));
        field(each,
            value == null && each.initial().isPresent() ? Literals.value(each.type(), each.initial().get()) : value);
      } catch (MessageException e) {
        throw e.within(each.name());
      }
    }
  }

  /** Bytes may come as a text in Base64, as JSON has no bytes. */
  private Object bytes(Layout.Field field, Object value) throws MessageException {
    Primitive type = field.primitive();
    if (!(value instanceof String text) || !field.type().isArray() || type == null || type.size() != 1) {
      return value;
    }
    try {
      return Base64.getDecoder().decode(text);
    } catch (IllegalArgumentException e) {
      throw problem("a text that is no Base64 stands for bytes: " + e.getMessage());
    }
  }

  private static String names(Layout layout) {
    return layout.fields().isEmpty()
        ? "none"
        : layout.fields().stream().map(Layout.Field::name).collect(Collectors.joining(", "));
  }

  private void field(Layout.Field field, Object value) throws MessageException {
    if (field.type().isArray()) {
      array(field, value);
    } else {
      single(field, value);
    }
  }

  private void single(Layout.Field field, Object value) throws MessageException {
    if (out.size() > MAX_SIZE) {
      throw problem("the message is too long");
    }
    if (field.nested() != null) {
      nested(field.nested(), value);
    } else {
      new ScalarEncoder(out).write(field, value);
    }
  }

  private void nested(Layout layout, Object value) throws MessageException {
    switch (value) {
      case null -> message(layout, Map.of());
      case DynamicMessage m when m.type().equals(layout.type()) -> out.bytes(m.bytes());
      case Map<?, ?> map -> message(layout, named(map));
      default -> throw problem("expected " + layout.type() + ", got " + ScalarEncoder.describe(value));
    }
  }

  private static Map<String, Object> named(Map<?, ?> map) {
    Map<String, Object> named = new LinkedHashMap<>();
    map.forEach((key, value) -> named.put(String.valueOf(key), value));
    return named;
  }

  private void array(Layout.Field field, Object value) throws MessageException {
    int length = value == null ? field.type().length() : length(field, value);
    if (field.type().arity() == FieldType.Arity.VARIABLE) {
      if (field.type().bound() > 0 && length > field.type().bound()) {
        throw problem("expected at most " + field.type().bound() + " values, got " + length);
      }
      out.array(length);
    } else if (length != field.type().length()) {
      throw problem("expected " + field.type().length() + " values, got " + length);
    }
    if (bulk(field.primitive(), value)) {
      return;
    }
    for (int i = 0; i < length; i++) {
      try {
        single(field, unwrap(element(value, i)));
      } catch (MessageException e) {
        throw e.within("[" + i + "]");
      }
    }
  }

  private boolean bulk(Primitive type, Object value) {
    switch (value) {
      case PrimitiveArray numbers when numbers.type() == type -> out.bytes(numbers.bytes());
      case byte[] bytes when type != null && type.size() == 1 -> out.bytes(bytes, 0, bytes.length);
      case float[] floats when type == Primitive.FLOAT32 -> out.floats(floats);
      case double[] doubles when type == Primitive.FLOAT64 -> out.doubles(doubles);
      case int[] ints when type == Primitive.INT32 -> out.ints(ints);
      case null, default -> {
        return false;
      }
    }
    return true;
  }

  private int length(Layout.Field field, Object value) throws MessageException {
    return switch (value) {
      case List<?> list -> list.size();
      case PrimitiveArray numbers -> numbers.size();
      case Object array when array.getClass().isArray() -> Array.getLength(array);
      default -> throw problem("expected " + field.type() + ", got " + ScalarEncoder.describe(value));
    };
  }

  private static Object element(Object value, int index) {
    return switch (value) {
      case null -> null;
      case List<?> list -> list.get(index);
      case PrimitiveArray numbers -> numbers.value(index);
      default -> Array.get(value, index);
    };
  }

  private static Object unwrap(Object value) {
    return switch (value) {
      case RosValue.Flag v -> v.value();
      case RosValue.Whole v -> v.type() == Primitive.UINT64 ? new BigInteger(v.text()) : v.value();
      case RosValue.Real v -> v.value();
      case RosValue.Text v -> v.value();
      case RosValue.Instant v -> v.nanos();
      case RosValue.Numbers v -> v.values();
      case RosValue.Texts v -> v.values();
      case RosValue.Nested v -> v.value();
      case RosValue.Messages v -> v.values();
      case null, default -> value;
    };
  }

  private MessageException problem(String text) {
    return new MessageException(text, "", out.size());
  }
}
