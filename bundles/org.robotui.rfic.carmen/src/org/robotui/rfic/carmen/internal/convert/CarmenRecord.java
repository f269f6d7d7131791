package org.robotui.rfic.carmen.internal.convert;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.carmen.message.FieldName;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcValue;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/**
 * A message as a record.
 *
 * @param schema its name
 * @param record its fields
 */
public record CarmenRecord(String schema, IpcRecord record) implements DynamicRecord {
  @Override
  public List<String> fields() {
    return record.names().stream().map(FieldName::name).toList();
  }

  @Override
  public Optional<FieldValue> field(String name) {
    return record.field(name).map(value -> value(name, value));
  }

  private static FieldValue value(String name, IpcValue value) {
    return switch (value) {
      case IpcValue.Whole w -> new FieldValue.Num(w.value(), Integer.toString(w.value()));
      case IpcValue.Small s -> new FieldValue.Num(s.value(), Float.toString(s.value()));
      case IpcValue.Real r -> new FieldValue.Num(r.value(), Double.toString(r.value()));
      case IpcValue.Text t -> new FieldValue.Text(t.value());
      case IpcValue.Octets o -> numbers(o.values());
      case IpcValue.Wholes w -> numbers(w.values());
      case IpcValue.Smalls s -> numbers(s.values());
      case IpcValue.Reals r -> new FieldValue.Numbers(Doubles.of(r.values()));
      case IpcValue.Items i -> items(name, i.values());
      case IpcValue.Members m -> new FieldValue.Nested(new CarmenRecord(name, m.record()));
      case IpcValue.Form f -> new FieldValue.Text(f.format().toString());
      case IpcValue.Absent a -> new FieldValue.Text("");
    };
  }

  private static FieldValue items(String name, List<IpcValue> values) {
    List<FieldValue> items = new ArrayList<>();
    values.forEach(value -> items.add(value(name, value)));
    return new FieldValue.Items(items);
  }

  private static FieldValue numbers(byte[] bytes) {
    double[] values = new double[bytes.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = bytes[i] & 0xff;
    }
    return new FieldValue.Numbers(Doubles.wrap(values));
  }

  private static FieldValue numbers(int[] wholes) {
    double[] values = new double[wholes.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = wholes[i];
    }
    return new FieldValue.Numbers(Doubles.wrap(values));
  }

  private static FieldValue numbers(float[] floats) {
    double[] values = new double[floats.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = floats[i];
    }
    return new FieldValue.Numbers(Doubles.wrap(values));
  }
}
