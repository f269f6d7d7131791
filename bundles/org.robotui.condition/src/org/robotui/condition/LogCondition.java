package org.robotui.condition;

import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import org.robotui.api.port.Input;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;

/**
 * The robot's programs log something.
 *
 * @param words in the name of the program or in what it says, empty for any
 * @param comparison how
 * @param severity with what
 */
record LogCondition(String words, Comparison comparison, Severity severity) implements Condition {
  @Override
  public Predicate<Input.Candidate> needs() {
    return candidate -> candidate.typeName().equals("LogEntry");
  }

  @Override
  public Verdict check(Signals signals, boolean active) {
    List<LogEntry> due = signals.log().stream().filter(this::holds).toList();
    if (due.isEmpty()) {
      return new Verdict.Fails();
    }
    LogEntry last = due.getLast();
    String more = due.size() > 1 ? " (and " + (due.size() - 1) + " before)" : "";
    return new Verdict.Holds(last.origin(), "says", last.severity() + ": " + last.message() + more);
  }

  @Override
  public boolean momentary() {
    return true;
  }

  private boolean holds(LogEntry entry) {
    String wanted = words.toLowerCase(Locale.ROOT);
    boolean named = entry.origin().toLowerCase(Locale.ROOT).contains(wanted)
        || entry.message().toLowerCase(Locale.ROOT).contains(wanted);
    return named && comparison.holdsFor(entry.severity(), severity);
  }
}
