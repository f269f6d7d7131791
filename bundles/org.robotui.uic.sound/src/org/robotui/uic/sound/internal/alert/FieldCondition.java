package org.robotui.uic.sound.internal.alert;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.robotui.api.input.Numerals;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;

/**
 * Compares a field of what a source sends. The field is looked for by the robot's name first, then by ours.
 *
 * @param source the port
 * @param path the field
 * @param comparison how
 * @param limit with what: a number, a word, true or false
 * @param slack by how much a number must come back for the alert to end
 */
record FieldCondition(SourceName source, FieldPath path, Comparison comparison, String limit, double slack)
    implements Condition {
  @Override
  public Predicate<Input.Candidate> needs() {
    return candidate -> source.fits(candidate.id());
  }

  @Override
  public Verdict check(Signals signals, boolean active) {
    List<Signals.Reading> readings = signals.readings(source);
    Verdict verdict = new Verdict.Unknown("nothing called '" + source.text() + "' is offered", false);
    for (Signals.Reading reading : readings) {
      verdict = check(reading, active);
      if (verdict instanceof Verdict.Holds) {
        return verdict;
      }
    }
    return verdict;
  }

  private Verdict check(Signals.Reading reading, boolean active) {
    if (!(reading.state() instanceof InputState.Live) || reading.newest().isEmpty()) {
      return new Verdict.Unknown(reading.name() + " sends nothing now", false);
    }
    Envelope<? extends Data> newest = reading.newest().getFirst();
    // Ours first, as in all views: the robot's field of that name may mean something else (ROS: ampere hours, not a
    // share).
    Optional<FieldValue> value = DataRecord.of(newest.value()).at(path).or(() -> newest.record().at(path));
    return value.map(found -> compare(reading.name(), found, active))
        .orElseGet(() -> noSuchField(reading.name(), newest.record()));
  }

  private Verdict noSuchField(String name, DynamicRecord record) {
    return new Verdict.Unknown(
        name + " (" + record.schema() + ") has no field '" + path + "'; it has " + String.join(", ", record.fields()),
        true);
  }

  private Verdict compare(String name, FieldValue found, boolean active) {
    return switch (found) {
      case FieldValue.Num n -> number(name, n.value(), n.exact(), active);
      case FieldValue.Time t -> number(name, t.nanos() * 1e-9, t.nanos() * 1e-9 + " s", active);
      case FieldValue.Flag f -> word(name, Boolean.toString(f.value()));
      case FieldValue.Text t -> word(name, t.value());
      default -> new Verdict.Unknown(name + "." + path + " is no single value; name one of its elements or fields",
          true);
    };
  }

  private Verdict number(String name, double value, String exact, boolean active) {
    Optional<Double> number = Numerals.decimal(limit);
    if (number.isEmpty()) {
      return new Verdict.Unknown(name + "." + path + " is a number and cannot be compared with '" + limit + "'", true);
    }
    return verdict(comparison.holds(value, number.get(), active ? slack : 0), name, exact);
  }

  private Verdict word(String name, String value) {
    if (comparison.ordered()) {
      return new Verdict.Unknown(name + "." + path + " is '" + value + "', which is no number; compare it by == or !=",
          true);
    }
    return verdict(comparison.holds(value, limit), name, value);
  }

  private Verdict verdict(boolean holds, String name, String value) {
    return holds ? new Verdict.Holds(name + "." + path, "is", value) : new Verdict.Fails();
  }
}
