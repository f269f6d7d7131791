package org.robotui.condition;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.robotui.api.input.Numerals;
import org.robotui.api.port.Input;
import org.robotui.data.record.FieldPath;

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
    String name = reading.name();
    return switch (FieldLookup.of(reading, path)) {
      case Operand.Number n -> number(name, n.value(), n.text(), active);
      case Operand.Truth t -> word(name, t.text());
      case Operand.Word w -> word(name, w.text());
      case Operand.Missing m -> new Verdict.Unknown(m.reason(), m.wrong());
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
