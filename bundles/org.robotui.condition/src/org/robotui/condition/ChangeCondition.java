package org.robotui.condition;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.robotui.api.port.Input;
import org.robotui.data.record.FieldPath;

/** A field of what a source sends is another than before. What is seen first is no change. */
final class ChangeCondition implements Condition {
  private final SourceName source;
  private final FieldPath path;
  private final Map<String, String> before = new HashMap<>();

  ChangeCondition(SourceName source, FieldPath path) {
    this.source = source;
    this.path = path;
  }

  @Override
  public Predicate<Input.Candidate> needs() {
    return candidate -> source.fits(candidate.id());
  }

  @Override
  public boolean momentary() {
    return true;
  }

  @Override
  public Verdict check(Signals signals, boolean active) {
    List<Signals.Reading> readings = signals.readings(source);
    Verdict verdict = new Verdict.Unknown("nothing called '" + source.text() + "' is offered", false);
    for (Signals.Reading reading : readings) {
      Verdict one = check(reading);
      verdict = verdict instanceof Verdict.Holds ? verdict : one;
    }
    return verdict;
  }

  private Verdict check(Signals.Reading reading) {
    Operand now = FieldLookup.of(reading, path);
    if (now instanceof Operand.Missing missing) {
      return new Verdict.Unknown(missing.reason(), missing.wrong());
    }
    String old = before.put(reading.name(), now.text());
    return old == null || old.equals(now.text()) ? new Verdict.Fails()
        : new Verdict.Holds(reading.name() + "." + path, "is", now.text() + ", was " + old);
  }
}
