package org.robotui.api.input;

import java.math.BigInteger;
import java.util.Optional;
import java.util.regex.Pattern;

/** Numbers as files have them: not all that Java takes for one, such as {@code 1d}, and not infinity. */
public final class Numerals {
  /** Far more digits than a number has, and few enough that reading them takes no time. */
  private static final int LONGEST = 1_000;
  private static final int HEX = 16;
  /** Until here a double tells whole numbers apart, and their digits are fewer than those of an exponent say. */
  private static final double WHOLE_UNTIL = 1e15;
  private static final Pattern DECIMAL = Pattern.compile("[-+]?(\\d+(\\.\\d*)?|\\.\\d+)([eE][-+]?\\d+)?");
  /** Not with zeros in front: what is meant by 010 is 8 for some, and 10 for others. */
  private static final Pattern WHOLE = Pattern.compile("[-+]?(0|[1-9]\\d*|0[xX][0-9a-fA-F]+)");

  private Numerals() {}

  /**
   * Reads a number.
   *
   * @param text the number and nothing else, its decimals behind a point
   * @return the number, which is finite; empty where it is none or too large for a double
   */
  public static Optional<Double> decimal(String text) {
    return isDecimal(text) ? Optional.of(Double.valueOf(text)).filter(Double::isFinite) : Optional.empty();
  }

  /**
   * Writes a number so that {@link #decimal} reads the same one.
   *
   * @param value a number
   * @return as few digits as that takes, whole numbers without a point; {@code NaN} and {@code Infinity} as Java has
   * them
   */
  public static String text(double value) {
    return value == Math.rint(value) && Math.abs(value) < WHOLE_UNTIL ? Long.toString((long) value)
        : Double.toString(value);
  }

  /**
   * Reads a whole number of any size.
   *
   * @param text the number and nothing else, decimal or {@code 0x} hexadecimal
   * @return the number; empty where it is none
   */
  public static Optional<BigInteger> whole(String text) {
    if (text.length() > LONGEST || !WHOLE.matcher(text).matches()) {
      return Optional.empty();
    }
    String plain = text.replaceFirst("0[xX]", "");
    return Optional.of(new BigInteger(plain, plain.equals(text) ? 10 : HEX));
  }

  /** Whether it is written as a number, also where that is too large. */
  static boolean isDecimal(String text) {
    return text.length() <= LONGEST && DECIMAL.matcher(text).matches();
  }
}
