package org.robotui.condition;

import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;

/**
 * A number about how a source sends.
 *
 * @param measure which
 * @param source the source
 */
record Pace(Measure measure, SourceName source) implements Term {
  /** What is measured. */
  enum Measure {
    /** Seconds since the newest value came. */
    AGE("s"),
    /** How many come in a second. */
    RATE("Hz"),
    /** Seconds from the stamp of the newest value until it came. */
    DELAY("s");

    private final String unit;

    Measure(String unit) {
      this.unit = unit;
    }
  }

  @Override
  public Operand value(Look look) {
    String missing = source.text() + " has not sent anything yet";
    for (Signals.Reading reading : look.signals().readings(source)) {
      OptionalDouble number = number(reading);
      if (number.isPresent()) {
        look.seen().put("the " + measure.name().toLowerCase(Locale.ROOT) + " of " + reading.name(),
            String.format(Locale.ROOT, measure == Measure.DELAY ? "%.3f %s" : "%.1f %s", number.getAsDouble(),
                measure.unit));
        return Operand.Number.of(number.getAsDouble());
      }
      if (!reading.newest().isEmpty()) {
        missing = reading.name() + " has no stamps of a clock that is known";
      }
    }
    return new Operand.Missing(missing, false);
  }

  private OptionalDouble number(Signals.Reading reading) {
    return switch (reading.state()) {
      case InputState.Live live -> number(live.ageSeconds(), live.rateHz(), reading);
      case InputState.Stale stale -> number(stale.ageSeconds(), 0, reading);
      default -> OptionalDouble.empty();
    };
  }

  private OptionalDouble number(double age, double rate, Signals.Reading reading) {
    return switch (measure) {
      case AGE -> OptionalDouble.of(age);
      case RATE -> OptionalDouble.of(rate);
      case DELAY -> reading.delaySeconds();
    };
  }

  @Override
  public Predicate<Input.Candidate> needs() {
    return candidate -> source.fits(candidate.id());
  }
}
