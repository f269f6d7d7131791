package org.robotui.entity.odometry.internal.colored;

import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.port.NumberField;
import org.robotui.api.port.StreamField;
import org.robotui.data.Data;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldUnits;

/** The newest value of a field. One thread. */
final class NewestValue {
  private final StreamField field;
  private final NumberField reader;
  private double value = Double.NaN;
  private String unit = "";
  private Optional<String> problem = Optional.empty();

  NewestValue(StreamField field) {
    this.field = field;
    this.reader = new NumberField(field.path());
    this.problem = Optional.of("no value of " + field + " came yet");
  }

  /** Takes what its source sent, and the same by the robot's own names. */
  double take(Data data, Supplier<DynamicRecord> own) {
    switch (reader.read(DataRecord.of(data), own)) {
      case NumberField.Number n -> {
        value = n.value();
        unit = FieldUnits.of(n.schema(), field.path().toString());
        problem = Optional.empty();
      }
      case NumberField.Missing m -> {
        value = Double.NaN;
        problem = Optional.of(m.reason());
      }
    }
    return value;
  }

  /** NaN where it is not known. */
  double value() {
    return value;
  }

  String unit() {
    return unit;
  }

  /** Why it is not known. */
  Optional<String> problem() {
    return problem;
  }
}
