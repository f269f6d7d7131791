package org.robotui.uic.sound.internal.alert;

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
  private static final String TYPE = "Diagnostics";

  @Override
  public Predicate<Input.Candidate> needs() {
    return candidate -> candidate.typeName().equals(TYPE);
  }

  @Override
  public Verdict check(Signals signals, boolean active) {
    List<Signals.Reading> readings = signals.readings(TYPE);
    if (readings.stream().allMatch(reading -> reading.newest().isEmpty())) {
      return new Verdict.Unknown("the robot sends no diagnostics", false);
    }
    return readings.stream().flatMap(DiagnosticsCondition::items).filter(this::holds).findFirst()
        .<Verdict>map(item -> new Verdict.Holds(item.name(), "reports",
            item.level() + (item.message().isEmpty() ? "" : ": " + item.message())))
        .orElseGet(Verdict.Fails::new);
  }

  private static Stream<Diagnostics.Item> items(Signals.Reading reading) {
    return reading.newest().stream()
        .flatMap(e -> e.value() instanceof Diagnostics d ? d.items().stream() : Stream.empty());
  }

  private boolean holds(Diagnostics.Item item) {
    boolean named = item.name().toLowerCase(Locale.ROOT).contains(part.toLowerCase(Locale.ROOT));
    return named && comparison.holdsFor(item.level(), level);
  }
}
