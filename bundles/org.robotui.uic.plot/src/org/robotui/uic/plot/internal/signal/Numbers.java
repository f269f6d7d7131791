package org.robotui.uic.plot.internal.signal;

/** Numbers as they are written in signals and files: the same in all languages. */
public final class Numbers {
  private static final double EXACT_INTEGERS = 1e15;

  private Numbers() {}

  /** The shortest text that reads as the same number; whole numbers without decimals. */
  public static String text(double value) {
    return value == Math.rint(value) && Math.abs(value) < EXACT_INTEGERS ? Long.toString((long) value)
        : Double.toString(value);
  }

  /** Reads a number; the message names what was written. */
  public static double parse(String text) {
    try {
      return Double.parseDouble(text.strip());
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("'" + text.strip() + "' is no number", e);
    }
  }
}
