package org.robotui.uic.plugins.internal.model;

import java.util.Locale;
import org.robotui.ui.Figures;

/** Short durations as users read them. Pure. */
public final class Durations {
  private static final double MICRO = 1e3;
  private static final double MILLI = 1e6;
  private static final double SECOND = 1e9;
  private static final double TENTHS_UNTIL = 99.95;
  private static final double HUNDREDTHS_UNTIL = 9.995;

  private Durations() {}

  /** With three digits at most, and a unit; a dash for NaN. */
  public static String of(double nanos) {
    if (Double.isNaN(nanos)) {
      return Figures.UNKNOWN;
    }
    if (nanos < MICRO) {
      return Figures.of(nanos, 0, "ns");
    }
    if (nanos < MILLI) {
      return digits(nanos / MICRO, "\u00b5s");
    }
    return nanos < SECOND ? digits(nanos / MILLI, "ms") : digits(nanos / SECOND, "s");
  }

  private static String digits(double value, String unit) {
    return Figures.of(value, value < HUNDREDTHS_UNTIL ? 2 : value < TENTHS_UNTIL ? 1 : 0, unit);
  }

  /** A round duration of an axis, without needless zeros. */
  public static String round(double nanos) {
    return nanos < MICRO ? Figures.of(nanos, 0, "ns")
        : nanos < MILLI ? Figures.of(nanos / MICRO, 0, "\u00b5s")
            : nanos < SECOND ? Figures.of(nanos / MILLI, 0, "ms") : Figures.of(nanos / SECOND, 0, "s");
  }

  /** A period, as a rate where that is a round one. */
  public static String period(long nanos) {
    return nanos <= 0 ? Figures.UNKNOWN : of(nanos);
  }

  /** A count with its thousands apart. */
  public static String count(long value) {
    return String.format(Locale.ROOT, "%,d", value).replace(',', '\u2009');
  }
}
