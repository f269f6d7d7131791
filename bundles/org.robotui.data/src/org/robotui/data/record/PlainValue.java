package org.robotui.data.record;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;

/** Java values as fields of a record. */
final class PlainValue {
  private PlainValue() {}

  /** The field for a value; none for an empty optional. */
  static Optional<FieldValue> of(Object value) {
    return value instanceof Optional<?> optional ? optional.flatMap(PlainValue::of) : Optional.of(field(value));
  }

  private static FieldValue field(Object value) {
    return switch (value) {
      case Number n -> new FieldValue.Num(n.doubleValue(), n.toString());
      case Boolean b -> new FieldValue.Flag(b);
      case Doubles d -> new FieldValue.Numbers(d);
      case Floats f -> new FieldValue.Numbers(doubles(f));
      case Bytes b -> new FieldValue.Numbers(doubles(b));
      case Stamp s -> new FieldValue.Time(s.nanos());
      case FrameId f -> new FieldValue.Text(f.toString());
      case List<?> l -> new FieldValue.Items(l.stream().flatMap(v -> of(v).stream()).toList());
      case Map<?, ?> m -> new FieldValue.Nested(record(m));
      case DynamicRecord r -> new FieldValue.Nested(r);
      case Record r -> new FieldValue.Nested(DataRecord.ofRecord(r));
      default -> new FieldValue.Text(value.toString());
    };
  }

  private static DynamicRecord record(Map<?, ?> map) {
    Map<String, FieldValue> fields = new LinkedHashMap<>();
    map.forEach((key, value) -> of(value).ifPresent(v -> fields.put(key.toString(), v)));
    return new MapRecord("map", fields);
  }

  private static Doubles doubles(Floats floats) {
    double[] values = new double[floats.size()];
    for (int i = 0; i < values.length; i++) {
      values[i] = floats.get(i);
    }
    return Doubles.wrap(values);
  }

  private static Doubles doubles(Bytes bytes) {
    double[] values = new double[bytes.size()];
    for (int i = 0; i < values.length; i++) {
      values[i] = bytes.unsigned(i);
    }
    return Doubles.wrap(values);
  }
}
