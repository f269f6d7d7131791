package org.robotui.condition;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;

/**
 * A source that sent has ceased to: its values are old, it failed, or it is gone. One that never sent is not missed.
 */
final class StaleCondition implements Condition {
  private final SourceName source;
  private boolean seen;

  StaleCondition(SourceName source) {
    this.source = source;
  }

  @Override
  public Predicate<Input.Candidate> needs() {
    return candidate -> source.fits(candidate.id());
  }

  @Override
  public Verdict check(Signals signals, boolean active) {
    List<Signals.Reading> readings = signals.readings(source);
    seen |= readings.stream().anyMatch(reading -> reading.state() instanceof InputState.Live);
    if (!seen) {
      return new Verdict.Unknown(source.text() + " has not sent anything yet", false);
    }
    Optional<Signals.Reading> silent =
        readings.stream().filter(reading -> !(reading.state() instanceof InputState.Live)).findFirst();
    if (readings.isEmpty()) {
      return new Verdict.Holds(source.text(), "is", "no longer offered");
    }
    return silent.<Verdict>map(reading -> holds(reading)).orElseGet(Verdict.Fails::new);
  }

  private static Verdict.Holds holds(Signals.Reading reading) {
    return switch (reading.state()) {
      case InputState.Stale s -> new Verdict.Holds(reading.name(), "sent",
          String.format(Locale.ROOT, "nothing for %.1f s", s.ageSeconds()));
      default -> new Verdict.Holds(reading.name(), "is silent:", reading.state().explanation());
    };
  }
}
