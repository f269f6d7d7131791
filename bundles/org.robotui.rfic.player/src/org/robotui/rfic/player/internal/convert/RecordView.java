package org.robotui.rfic.player.internal.convert;

import java.util.List;
import java.util.Optional;
import org.robotui.data.Doubles;
import org.robotui.data.DynamicRecord;
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
  public Optional<org.robotui.data.FieldValue> field(String name) {
    return body.field(name).map(RecordView::value);
  }

  private static org.robotui.data.FieldValue value(FieldValue value) {
    return switch (value) {
      case FieldValue.Whole w -> new org.robotui.data.FieldValue.Num(w.value(), Long.toString(w.value()));
      case FieldValue.Real r -> new org.robotui.data.FieldValue.Num(r.value(), Double.toString(r.value()));
      case FieldValue.Flag f -> new org.robotui.data.FieldValue.Flag(f.value());
      case FieldValue.Text t -> new org.robotui.data.FieldValue.Text(t.value());
      case FieldValue.Bytes b -> new org.robotui.data.FieldValue.Numbers(numbers(b.value()));
      case FieldValue.Numbers n -> new org.robotui.data.FieldValue.Numbers(Doubles.of(n.values()));
      case FieldValue.Nested n -> nested(n.value());
      case FieldValue.Many m -> new org.robotui.data.FieldValue.Items(m.values().stream().map(RecordView::nested).toList());
    };
  }

  private static org.robotui.data.FieldValue nested(PlayerRecord record) {
    return new org.robotui.data.FieldValue.Nested(new RecordView(record.layout().name(), record));
  }

  private static Doubles numbers(byte[] bytes) {
    double[] values = new double[bytes.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = bytes[i] & 0xff;
    }
    return Doubles.wrap(values);
  }
}
