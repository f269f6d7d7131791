package org.robotui.player.log;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Numbers as C's printf writes them, and back. */
record NumberFormat(boolean plus, boolean zeros, int width, int decimals, boolean whole) {

  private static final Pattern FORMAT = Pattern.compile("%(\\+?)(0?)(\\d*)(?:\\.(\\d+))?([df])");
  private static final int USUAL = 6;

  static NumberFormat of(String format) {
    Matcher parts = FORMAT.matcher(format);
    if (!parts.matches()) {
      throw new IllegalArgumentException("'" + format + "' is no format of a number");
    }
    return new NumberFormat(!parts.group(1).isEmpty(), !parts.group(2).isEmpty(),
        parts.group(3).isEmpty() ? 0 : Integer.parseInt(parts.group(3)),
        parts.group(4) == null ? USUAL : Integer.parseInt(parts.group(4)), parts.group(5).equals("d"));
  }

  String write(double value) {
    boolean negative = Double.doubleToRawLongBits(value) < 0 && !Double.isNaN(value);
    String sign = negative ? "-" : plus ? "+" : "";
    String digits = digits(Math.abs(value));
    boolean fills = zeros && Double.isFinite(value);
    String padding = (fills ? "0" : " ").repeat(Math.max(0, width - sign.length() - digits.length()));
    return fills ? sign + padding + digits : padding + sign + digits;
  }

  private String digits(double size) {
    if (!Double.isFinite(size)) {
      return Double.isNaN(size) ? "nan" : "inf";
    }
    // printf rounds the number itself, not its shortest decimal form
    return new BigDecimal(size).setScale(whole ? 0 : decimals, RoundingMode.HALF_EVEN).toPlainString();
  }

  static double read(String text) {
    return switch (text) {
      case "nan", "-nan", "+nan" -> Double.NaN;
      case "inf", "+inf" -> Double.POSITIVE_INFINITY;
      case "-inf" -> Double.NEGATIVE_INFINITY;
      default -> Double.parseDouble(text);
    };
  }
}
