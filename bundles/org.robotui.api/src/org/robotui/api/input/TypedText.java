package org.robotui.api.input;

import java.math.BigInteger;
import java.util.Locale;
import java.util.Optional;

/**
 * Reads one value that was typed, in every field of every view alike. Blanks around it do not count. Numbers may have a
 * real minus sign, as it stands in figures that are shown and copied, and a decimal comma where nobody can take it for
 * one of thousands. The message of {@link Unreadable} goes on with a sentence that begins with the field or with what
 * was typed, such as "is no number".
 */
public final class TypedText {
  private static final char MINUS = '\u2212';
  private static final String COMMA = "[-+]?\\d*,\\d+([eE][-+]?\\d+)?";
  /** 1,500 is a thousand and a half for some, and one and a half for others; 0,500 is clear. */
  private static final String THOUSANDS = "[-+]?[1-9]\\d{0,2},\\d{3}";

  private TypedText() {}

  /**
   * Reads a truth value.
   *
   * @param typed true, yes, on, 1, or false, no, off, 0
   * @return the value
   * @throws Unreadable where it is something else
   */
  public static boolean flag(String typed) throws Unreadable {
    return switch (typed.strip().toLowerCase(Locale.ROOT)) {
      case "true", "yes", "on", "1" -> true;
      case "false", "no", "off", "0" -> false;
      default -> throw new Unreadable("is neither true nor false");
    };
  }

  /**
   * Reads a whole number within bounds.
   *
   * @param typed decimal or {@code 0x} hexadecimal
   * @param least the smallest allowed
   * @param most the largest allowed
   * @return the number
   * @throws Unreadable where it is no whole number, or beyond the bounds
   */
  public static BigInteger whole(String typed, BigInteger least, BigInteger most) throws Unreadable {
    String text = signed(typed);
    Optional<BigInteger> value = Numerals.whole(text);
    if (value.isEmpty()) {
      throw new Unreadable(
          "is no whole number" + (text.matches("[-+]?0+\\d+") ? "; write it without zeros in front" : ""));
    }
    if (value.get().compareTo(least) < 0 || value.get().compareTo(most) > 0) {
      throw new Unreadable("must be from " + least + " to " + most);
    }
    return value.get();
  }

  /**
   * Reads a whole number of 64 bits with a sign.
   *
   * @param typed decimal or {@code 0x} hexadecimal
   * @return the number
   * @throws Unreadable where it is no whole number, or needs more bits
   */
  public static long whole(String typed) throws Unreadable {
    return whole(typed, BigInteger.valueOf(Long.MIN_VALUE), BigInteger.valueOf(Long.MAX_VALUE)).longValueExact();
  }

  /**
   * Reads a number that may be none or infinite, as robots may mean it.
   *
   * @param typed a number, or nan or inf as C, Python and YAML write them
   * @return the number
   * @throws Unreadable where it is no number, or too large to be a finite one
   */
  public static double real(String typed) throws Unreadable {
    return switch (signed(typed).toLowerCase(Locale.ROOT)) {
      case "nan", ".nan" -> Double.NaN;
      case "inf", "+inf", ".inf", "+.inf", "infinity", "+infinity" -> Double.POSITIVE_INFINITY;
      case "-inf", "-.inf", "-infinity" -> Double.NEGATIVE_INFINITY;
      default -> decimal(signed(typed));
    };
  }

  /**
   * Reads a finite number.
   *
   * @param typed a number
   * @return the number
   * @throws Unreadable where it is no finite number
   */
  public static double finite(String typed) throws Unreadable {
    double value = real(typed);
    if (!Double.isFinite(value)) {
      throw new Unreadable("is no finite number");
    }
    return value;
  }

  /**
   * Reads a finite number within bounds.
   *
   * @param typed a number
   * @param least the smallest allowed
   * @param most the largest allowed
   * @param expected what stands behind "must be" where it is beyond them
   * @return the number
   * @throws Unreadable where it is no finite number, or beyond the bounds
   */
  public static double within(String typed, double least, double most, String expected) throws Unreadable {
    double value = finite(typed);
    if (value < least || value > most) {
      throw new Unreadable("must be " + expected);
    }
    return value;
  }

  private static double decimal(String text) throws Unreadable {
    String pointed = text.matches(COMMA) && !text.matches(THOUSANDS) ? text.replace(',', '.') : text;
    Optional<Double> value = Numerals.decimal(pointed);
    if (value.isPresent()) {
      return value.get();
    }
    throw new Unreadable(Numerals.isDecimal(pointed) ? "is too large"
        : text.indexOf(',') >= 0 ? "is no number; decimals begin with a point" : "is no number");
  }

  private static String signed(String typed) {
    return typed.strip().replace(MINUS, '-');
  }
}
