package org.robotui.uic.parameters.internal.view;

import java.util.Locale;
import java.util.Optional;
import org.robotui.api.input.Unreadable;
import org.robotui.api.port.Browser.Choice;
import org.robotui.api.port.Browser.Tunable;
import org.robotui.uic.parameters.internal.model.ValueReader;
import org.robotui.uic.parameters.internal.model.ValueText;

/** What stands in the fields of the form, and what may be typed there. Pure. */
public final class KnobText {
  /** A wider range cannot be set with a slider. */
  private static final double WIDEST = 1e7;

  private KnobText() {}

  /** Where a slider makes sense: a number within two sensible bounds. */
  static boolean isRanged(Tunable tunable) {
    double width = least(tunable, Double.NaN) < most(tunable, Double.NaN) ? most(tunable, 0) - least(tunable, 0) : -1;
    return tunable.value() instanceof Number && tunable.choices().isEmpty() && width > 0 && width <= WIDEST;
  }

  static double least(Tunable tunable, double without) {
    return number(tunable.least(), without);
  }

  static double most(Tunable tunable, double without) {
    return number(tunable.most(), without);
  }

  private static double number(Optional<Object> bound, double without) {
    return bound.filter(Number.class::isInstance).map(value -> ((Number) value).doubleValue()).orElse(without);
  }

  /** The value at a place of the slider, in sensible steps. */
  static Object at(Tunable tunable, double offset) {
    double value = least(tunable, 0) + offset;
    if (tunable.value() instanceof Long) {
      return Math.round(value);
    }
    double step = Math.pow(10, Math.floor(Math.log10(most(tunable, 0) - least(tunable, 0))) - 3);
    double rounded = Math.round(value / step) * step;
    return Math.clamp(Double.parseDouble(String.format(Locale.ROOT, "%.10g", rounded)), least(tunable, value),
        most(tunable, value));
  }

  static String of(Tunable tunable, Object value) {
    return choice(tunable, value).map(Choice::name).orElseGet(() -> ValueText.of(value));
  }

  static Optional<Choice> choice(Tunable tunable, Object value) {
    return tunable.choices().stream().filter(c -> c.value().equals(value)).findFirst();
  }

  /** Reads what was typed, within the bounds. */
  public static Object read(Tunable tunable, String typed) throws Unreadable {
    Object value = ValueReader.read(typed, tunable.value());
    if (value instanceof Number number
        && (number.doubleValue() < least(tunable, Double.NEGATIVE_INFINITY)
            || number.doubleValue() > most(tunable, Double.POSITIVE_INFINITY))) {
      throw new Unreadable(range(tunable));
    }
    return value;
  }

  /** The bounds as a sentence. */
  static String range(Tunable tunable) {
    Optional<String> least = tunable.least().map(ValueText::of);
    Optional<String> most = tunable.most().map(ValueText::of);
    if (least.isPresent() && most.isPresent()) {
      return "It must be from " + least.get() + " to " + most.get();
    }
    return least.map(l -> "It must be at least " + l)
        .orElseGet(() -> most.map(m -> "It must be at most " + m).orElse(""));
  }
}
