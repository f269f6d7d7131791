package org.robotui.message.data;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/** A record of plain values, as an encoding that names its fields gives it, which also has bytes. */
record NamedRecord(String schema, Map<String, Object> all) implements ByteFields {
  @Override
  public List<String> fields() {
    return List.copyOf(all.keySet());
  }

  @Override
  public Optional<FieldValue> field(String name) {
    return Optional.ofNullable(all.get(name)).filter(FieldValue.class::isInstance).map(FieldValue.class::cast);
  }

  @Override
  public Optional<Bytes> bytes(String name) {
    return Optional.ofNullable(all.get(name)).filter(Bytes.class::isInstance).map(Bytes.class::cast);
  }

  /** Names and values in turns; a value is a number, a text, numbers, bytes, another record, or a list of these. */
  static NamedRecord of(Object... namesAndValues) {
    Map<String, Object> all = new LinkedHashMap<>();
    for (int i = 0; i < namesAndValues.length; i += 2) {
      all.put((String) namesAndValues[i], value(namesAndValues[i + 1]));
    }
    return new NamedRecord("a", all);
  }

  private static Object value(Object plain) {
    return switch (plain) {
      case Number n -> new FieldValue.Num(n.doubleValue(), n.toString());
      case String text -> new FieldValue.Text(text);
      case DynamicRecord inner -> new FieldValue.Nested(inner);
      case double[] numbers -> new FieldValue.Numbers(Doubles.wrap(numbers));
      case List<?> items -> new FieldValue.Items(items.stream().map(v -> (FieldValue) value(v)).toList());
      default -> plain;
    };
  }
}
