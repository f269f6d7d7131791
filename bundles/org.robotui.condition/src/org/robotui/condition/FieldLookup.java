package org.robotui.condition;

import java.util.Optional;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;

/** Finds a field in what a source sends. */
final class FieldLookup {
  private FieldLookup() {}

  /**
   * The field as it is now. It is looked for by our name first, as in all views: the robot's field of that name may
   * mean something else (ROS: ampere hours, not a share).
   */
  static Operand of(Signals.Reading reading, FieldPath path) {
    if (!(reading.state() instanceof InputState.Live) || reading.newest().isEmpty()) {
      return new Operand.Missing(reading.name() + " sends nothing now", false);
    }
    Envelope<? extends Data> newest = reading.newest().getFirst();
    Optional<FieldValue> value = DataRecord.of(newest.value()).at(path).or(() -> newest.record().at(path));
    return value.map(found -> operand(reading.name(), path, found))
        .orElseGet(() -> noSuchField(reading.name(), path, newest.record()));
  }

  private static Operand noSuchField(String name, FieldPath path, DynamicRecord record) {
    return new Operand.Missing(
        name + " (" + record.schema() + ") has no field '" + path + "'; it has " + String.join(", ", record.fields()),
        true);
  }

  private static Operand operand(String name, FieldPath path, FieldValue found) {
    return switch (found) {
      case FieldValue.Num n -> new Operand.Number(n.value(), n.exact());
      case FieldValue.Time t -> new Operand.Number(t.nanos() * 1e-9, t.nanos() * 1e-9 + " s");
      case FieldValue.Flag f -> new Operand.Truth(f.value());
      case FieldValue.Text t -> new Operand.Word(t.value());
      default -> new Operand.Missing(name + "." + path + " is no single value; name one of its elements or fields",
          true);
    };
  }
}
