package org.robotui.player.layout;

import java.lang.reflect.Array;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Makes browsable records from plain Java values. */
final class RecordBuilder {

  private static final int BYTE = 0xff;

  private RecordBuilder() {}

  static PlayerRecord build(StructLayout struct, Map<String, ?> values) {
    values.keySet().stream().filter(name -> struct.field(name).isEmpty()).findFirst().ifPresent(name -> {
      throw new IllegalArgumentException(struct.name() + " has no field '" + name + "', but " + struct.fields());
    });
    return new PlayerRecord(struct, struct.fields().stream()
        .map(field -> values.containsKey(field.name()) ? given(field, values.get(field.name())) : zero(field))
        .toArray());
  }

  private static Object given(FieldLayout field, Object value) {
    try {
      return field.isArray() ? array(field, value) : one(field, value);
    } catch (ClassCastException | NumberFormatException e) {
      throw new IllegalArgumentException("'" + value + "' is no value for the field " + field, e);
    }
  }

  private static Object zero(FieldLayout field) {
    if (field.struct().isPresent()) {
      StructLayout struct = field.struct().get();
      return field.isArray() ? IntStream.range(0, field.length()).mapToObj(i -> build(struct, Map.of())).toList()
          : build(struct, Map.of());
    }
    Primitive primitive = field.primitive().orElseThrow();
    return field.isArray() ? primitive.zeros(field.length()) : primitive.zero();
  }

  private static Object one(FieldLayout field, Object value) {
    if (field.struct().isPresent()) {
      return value instanceof PlayerRecord ready ? ready : build(field.struct().get(), fields(value));
    }
    return field.primitive().orElseThrow().of(value);
  }

  private static Object array(FieldLayout field, Object value) {
    int length = FieldCodec.length(value);
    List<Object> elements = IntStream.range(0, length)
        .mapToObj(i -> value instanceof List<?> list ? (Object) list.get(i) : Array.get(value, i))
        .toList();
    if (field.struct().isPresent()) {
      return elements.stream().map(each -> one(field, each)).toList();
    }
    Primitive primitive = field.primitive().orElseThrow();
    Object array = primitive.zeros(length);
    for (int i = 0; i < length; i++) {
      Array.set(array, i,
          primitive.isByte() ? (byte) (((Number) elements.get(i)).intValue() & BYTE) : primitive.of(elements.get(i)));
    }
    return array;
  }

  @SuppressWarnings("unchecked")
  private static Map<String, ?> fields(Object value) {
    return (Map<String, ?>) value;
  }
}
