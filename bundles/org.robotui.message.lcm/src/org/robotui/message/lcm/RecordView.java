package org.robotui.message.lcm;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.lcm.type.LcmValue;
import org.robotui.lcm.type.MemberDefinition;

/**
 * An LCM message of any type as a record. Nothing is converted before it is asked for.
 *
 * @param message the message
 */
public record RecordView(LcmRecord message) implements DynamicRecord {
  @Override
  public String schema() {
    return message.type();
  }

  @Override
  public List<String> fields() {
    return message.members().stream().map(MemberDefinition::name).toList();
  }

  @Override
  public Optional<FieldValue> field(String name) {
    return message.member(name).map(RecordView::value);
  }

  private static FieldValue value(LcmValue value) {
    return switch (value) {
      case LcmValue.Whole w -> new FieldValue.Num(w.value(), Long.toString(w.value()));
      case LcmValue.Real r -> new FieldValue.Num(r.value(), Double.toString(r.value()));
      case LcmValue.Flag f -> new FieldValue.Flag(f.value());
      case LcmValue.Text t -> new FieldValue.Text(t.value());
      case LcmValue.Nested n -> new FieldValue.Nested(new RecordView(n.value()));
      case LcmValue.Numbers n -> rows(n.value().toDoubles(), n.value().shape());
      case LcmValue.Texts t -> rows(t.values().stream().<FieldValue>map(FieldValue.Text::new).toList(), t.shape());
      case LcmValue.Records r -> rows(
          r.values().stream().<FieldValue>map(x -> new FieldValue.Nested(new RecordView(x))).toList(), r.shape());
    };
  }

  /** An array of several dimensions is rows of rows, so that each index has its place in a path. */
  private static FieldValue rows(double[] numbers, List<Integer> shape) {
    if (shape.size() < 2) {
      return new FieldValue.Numbers(Doubles.wrap(numbers));
    }
    int rows = shape.getFirst();
    int width = rows == 0 ? 0 : numbers.length / rows;
    List<FieldValue> items = new ArrayList<>();
    for (int i = 0; i < rows; i++) {
      items.add(rows(Arrays.copyOfRange(numbers, i * width, (i + 1) * width), shape.subList(1, shape.size())));
    }
    return new FieldValue.Items(items);
  }

  private static FieldValue rows(List<FieldValue> values, List<Integer> shape) {
    if (shape.size() < 2) {
      return new FieldValue.Items(values);
    }
    int rows = shape.getFirst();
    int width = rows == 0 ? 0 : values.size() / rows;
    List<FieldValue> items = new ArrayList<>();
    for (int i = 0; i < rows; i++) {
      items.add(rows(values.subList(i * width, (i + 1) * width), shape.subList(1, shape.size())));
    }
    return new FieldValue.Items(items);
  }
}
