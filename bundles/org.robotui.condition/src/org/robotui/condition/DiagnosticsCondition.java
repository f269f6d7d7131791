package org.robotui.condition;

import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.robotui.api.port.Input;
import org.robotui.data.status.Diagnostics;

/**
 * A part of the robot reports a level.
 *
 * @param part words in the name of the part, empty for any
 * @param comparison how
 * @param level with what
 */
record DiagnosticsCondition(String part, Comparison comparison, Diagnostics.Level level) implements Condition {
  static final Predicate<Input.Candidate> NEEDS = candidate -> candidate.typeName().equals(DiagnosticsCondition.TYPE);
  private static final String TYPE = "Diagnostics";

  @Override
  public Predicate<Input.Candidate> needs() {
    return NEEDS;
  }

  @Override
  public Verdict check(Signals signals, boolean active) {
    if (signals.readings(TYPE).stream().allMatch(reading -> reading.newest().isEmpty())) {
      return new Verdict.Unknown("the robot sends no diagnostics", false);
    }
    return items(signals, part).stream().filter(item -> comparison.holdsFor(item.level(), level)).findFirst()
        .<Verdict>map(item -> new Verdict.Holds(item.name(), "reports", words(item)))
        .orElseGet(Verdict.Fails::new);
  }

  /** The level with what the part says of it. */
  static String words(Diagnostics.Item item) {
    return item.level() + (item.message().isEmpty() ? "" : ": " + item.message());
  }

  /** The parts whose names contain a word. */
  static List<Diagnostics.Item> items(Signals signals, String part) {
    String wanted = part.toLowerCase(Locale.ROOT);
    return signals.readings(TYPE).stream().flatMap(reading -> reading.newest().stream())
        .flatMap(e -> e.value() instanceof Diagnostics d ? d.items().stream() : Stream.empty())
        .filter(item -> item.name().toLowerCase(Locale.ROOT).contains(wanted)).toList();
  }
}
