package org.robotui.message.data;

import java.util.List;
import java.util.Optional;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.FieldValue;
import org.robotui.message.DynamicMessage;
import org.robotui.message.FieldDefinition;
import org.robotui.message.RosValue;

/**
 * A ROS message of any type as a record.
 *
 * @param message the message, decoded when asked
 */
public record MessageRecord(DynamicMessage message) implements ByteFields {
  @Override
  public String schema() {
    return message.type();
  }

  @Override
  public List<String> fields() {
    return message.fields().stream().map(FieldDefinition::name).toList();
  }

  @Override
  public Optional<FieldValue> field(String name) {
    return message.field(name).map(MessageRecord::value);
  }

  @Override
  public Optional<Bytes> bytes(String name) {
    return message.field(name).filter(RosValue.Numbers.class::isInstance).map(v -> ((RosValue.Numbers) v).values())
        .filter(numbers -> numbers.type().size() == 1).map(numbers -> Bytes.wrap(numbers.bytes()));
  }

  private static FieldValue value(RosValue value) {
    return switch (value) {
      case RosValue.Flag f -> new FieldValue.Flag(f.value());
      case RosValue.Whole w -> new FieldValue.Num(Double.parseDouble(w.text()), w.text());
      case RosValue.Real r -> new FieldValue.Num(r.value(), Double.toString(r.value()));
      case RosValue.Text t -> new FieldValue.Text(t.value());
      case RosValue.Instant t -> new FieldValue.Time(t.nanos());
      case RosValue.Numbers n -> new FieldValue.Numbers(Doubles.wrap(n.values().toDoubles()));
      case RosValue.Texts t -> new FieldValue.Items(t.values().stream().<FieldValue>map(FieldValue.Text::new).toList());
      case RosValue.Nested n -> new FieldValue.Nested(new MessageRecord(n.value()));
      case RosValue.Messages m -> new FieldValue.Items(
          m.values().stream().<FieldValue>map(x -> new FieldValue.Nested(new MessageRecord(x))).toList());
    };
  }
}
