package org.robotui.condition;

import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A condition that must hold for some time.
 *
 * @param condition what must hold
 * @param forNanos for how long, 0 for no time at all
 */
public record TimedCondition(Condition condition, long forNanos) {
  private static final Pattern TIMED =
      Pattern.compile("(.*\\S)\\s+for\\s+(\\d{1,9}(?:\\.\\d{1,9})?)\\s*(ms|s|min|h)", Pattern.DOTALL);
  private static final Map<String, Double> NANOS = Map.of("ms", 1e6, "s", 1e9, "min", 60e9, "h", 3600e9);

  /**
   * Reads a condition, which may end with a time.
   *
   * @param text as for {@link Conditions#parse}, for example {@code battery charge < 0.2 for 5 s}; units are ms, s, min
   * and h
   * @param slack hysteresis of numbers, not negative
   * @return the condition and its time
   * @throws IllegalArgumentException where it cannot be read; the message says what is wrong and what could be written
   */
  public static TimedCondition parse(String text, double slack) {
    Matcher timed = TIMED.matcher(text.strip());
    if (!timed.matches()) {
      return new TimedCondition(Conditions.parse(text, slack), 0);
    }
    Condition condition = Conditions.parse(timed.group(1), slack);
    if (condition.momentary()) {
      throw new IllegalArgumentException(
          "'" + timed.group(1) + "' is over as soon as it happens, so that it cannot last; leave out 'for'");
    }
    return new TimedCondition(condition,
        Math.round(Double.parseDouble(timed.group(2)) * NANOS.get(timed.group(3))));
  }
}
