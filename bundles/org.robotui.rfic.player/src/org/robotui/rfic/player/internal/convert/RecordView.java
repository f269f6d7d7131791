package org.robotui.rfic.player.internal.convert;

import java.util.List;
import java.util.Optional;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.player.layout.FieldLayout;
import org.robotui.player.layout.FieldValue;
import org.robotui.player.layout.PlayerRecord;

/**
 * A body of any message as a record.
 *
 * @param schema the message's name, such as {@code position2d/state}
 * @param body its fields
 */
public record RecordView(String schema, PlayerRecord body) implements DynamicRecord {
  @Override
  public List<String> fields() {
    return body.layout().fields().stream().map(FieldLayout::name).toList();
  }

  @Override
  public Optional<org.robotui.data.record.FieldValue> field(String name) {
    return body.field(name).map(RecordView::value);
  }

  private static org.robotui.data.record.FieldValue value(FieldValue value) {
    return switch (value) {
      case FieldValue.Whole w -> new org.robotui.data.record.FieldValue.Num(w.value(), Long.toString(w.value()));
      case FieldValue.Real r -> new org.robotui.data.record.FieldValue.Num(r.value(), Double.toString(r.value()));
      case FieldValue.Flag f -> new org.robotui.data.record.FieldValue.Flag(f.value());
      case FieldValue.Text t -> new org.robotui.data.record.FieldValue.Text(t.value());
      case FieldValue.Bytes b -> new org.robotui.data.record.FieldValue.Numbers(numbers(b.value()));
      case FieldValue.Numbers n -> new org.robotui.data.record.FieldValue.Numbers(Doubles.of(n.values()));
      case FieldValue.Nested n -> nested(n.value());
      case FieldValue.Many m -> new org.robotui.data.record.FieldValue.Items(
          m.values().stream().map(RecordView::nested).toList());
    };
  }

  private static org.robotui.data.record.FieldValue nested(PlayerRecord record) {
    return new org.robotui.data.record.FieldValue.Nested(new RecordView(record.layout().name(), record));
  }

  private static Doubles numbers(byte[] bytes) {
    double[] values = new double[bytes.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = bytes[i] & 0xff;
    }
    return Doubles.wrap(values);
  }
}
