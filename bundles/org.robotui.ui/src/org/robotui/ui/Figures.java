package org.robotui.ui;

import java.util.Locale;
import java.util.stream.DoubleStream;

/** Figures as users read them: fixed decimals, a real minus sign, a unit. Pure, for all threads. */
public final class Figures {
  /** What stands for a number that is not known. */
  public static final String UNKNOWN = "\u2014";

  /** From here on a figure would be longer than any place for it. */
  private static final double LONG = 1e12;
  private static final char MINUS = '\u2212';
  private static final double SECONDS_PER_MINUTE = 60;
  private static final double MINUTES_PER_HOUR = 60;
  private static final double TENTHS_UNTIL = 9.95;
  private static final double MILLIS_UNTIL = 0.0995;

  private static final double CLOCKS_DIFFER = 0.1;

  private static final double HALF = 1e-9;
  /** A hundredth of it is still a number with all its digits. */
  private static final double FINEST = 1e-290;

  private Figures() {}

  /**
   * A number with fixed decimals. A value that rounds to zero has no sign.
   *
   * @param value the number
   * @param decimals how many
   * @return for example {@code −0.18}, {@code ∞}, or a dash for NaN
   */
  public static String fixed(double value, int decimals) {
    if (Double.isNaN(value)) {
      return UNKNOWN;
    }
    if (Double.isInfinite(value)) {
      return value > 0 ? "\u221e" : MINUS + "\u221e";
    }
    String text = Math.abs(value) < LONG
        ? String.format(Locale.ROOT, "%." + decimals + "f", Math.abs(value))
        : String.format(Locale.ROOT, "%.3e", Math.abs(value)).replace("e+", "e");
    boolean negative = value < 0 && text.chars().anyMatch(c -> c > '0' && c <= '9');
    return negative ? MINUS + text : text;
  }

  /**
   * A number with fixed decimals and a unit.
   *
   * @param value the number
   * @param decimals how many
   * @param unit for example {@code m/s}; empty for none
   * @return for example {@code 0.31 m/s}
   */
  public static String of(double value, int decimals, String unit) {
    return unit.isEmpty() ? fixed(value, decimals) : fixed(value, decimals) + "\u00a0" + unit;
  }

  /**
   * An angle in degrees.
   *
   * @param radians the angle
   * @param decimals how many
   * @return for example {@code −10.3°}
   */
  public static String degrees(double radians, int decimals) {
    String text = fixed(Math.toDegrees(radians), decimals);
    return Double.isFinite(radians) ? text + "\u00b0" : text;
  }

  /**
   * An age or a duration, as exact as it matters.
   *
   * @param seconds the time
   * @return for example {@code 12 ms}, {@code 2.1 s}, {@code 14 min}, {@code 3.5 h}
   */
  public static String age(double seconds) {
    double size = Math.abs(seconds);
    if (size < MILLIS_UNTIL) {
      return of(seconds * 1000, 0, "ms");
    }
    if (size < SECONDS_PER_MINUTE || Double.isNaN(seconds)) {
      return of(seconds, size < TENTHS_UNTIL ? 1 : 0, "s");
    }
    double minutes = seconds / SECONDS_PER_MINUTE;
    return Math.abs(minutes) < MINUTES_PER_HOUR ? of(minutes, 0, "min") : of(minutes / MINUTES_PER_HOUR, 1, "h");
  }

  /**
   * The age of a value. What the inexactness of clocks makes slightly negative is no age at all; a robot whose clock is
   * clearly ahead is shown as it is.
   *
   * @param seconds the time
   * @return as of {@link #age}
   */
  public static String ageOfValue(double seconds) {
    return age(seconds < 0 && seconds > -CLOCKS_DIFFER ? 0 : seconds);
  }

  /**
   * A rate.
   *
   * @param hertz values per second; 0 or less where it cannot be told
   * @return for example {@code 10.0 Hz}, or a dash
   */
  public static String rate(double hertz) {
    return hertz > 0 ? of(hertz, hertz >= 1000 ? 0 : 1, "Hz") : UNKNOWN;
  }

  /**
   * A round step for scales.
   *
   * @param least how large it is at least
   * @return the smallest of 1, 2, 5 times a power of ten that is not below it; 1 where that is no number above 0
   */
  public static double roundStep(double least) {
    if (!(least > 0) || !Double.isFinite(least)) {
      return 1;
    }
    double wanted = Math.max(FINEST, least);
    double power = Math.pow(10, Math.floor(Math.log10(wanted)));
    return DoubleStream.of(1, 2, 5, 10).map(m -> m * power).filter(s -> s >= wanted * (1 - HALF)).findFirst()
        .orElse(10 * power);
  }
}
