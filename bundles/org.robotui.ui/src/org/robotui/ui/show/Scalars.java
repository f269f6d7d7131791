package org.robotui.ui.show;

import org.robotui.api.input.Numerals;
import org.robotui.data.record.FieldValue;

/** Numbers and texts as YAML and JSON write them. */
final class Scalars {
  private static final int FIRST_PRINTABLE = 0x20;

  private Scalars() {}

  /** With the digits that the robot means. */
  static String yaml(FieldValue.Num number) {
    return Double.isFinite(number.value()) && !number.exact().isEmpty() ? number.exact() : yaml(number.value());
  }

  static String yaml(double value) {
    if (Double.isNaN(value)) {
      return ".nan";
    }
    return Double.isInfinite(value) ? value > 0 ? ".inf" : "-.inf" : Numerals.text(value);
  }

  /** JSON knows no NaN and no infinity: both are null, as other bridges of robots write them. */
  static String json(FieldValue.Num number) {
    return Double.isFinite(number.value()) && isJson(number.exact()) ? number.exact() : json(number.value());
  }

  static String json(double value) {
    return Double.isFinite(value) ? Numerals.text(value) : "null";
  }

  private static boolean isJson(String digits) {
    return digits.matches("-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][-+]?[0-9]+)?");
  }

  /** In quotation marks, with escapes that both YAML and JSON know. */
  static String quoted(String text) {
    StringBuilder quoted = new StringBuilder("\"");
    text.chars().forEach(c -> {
      switch (c) {
        case '"' -> quoted.append("\\\"");
        case '\\' -> quoted.append("\\\\");
        case '\n' -> quoted.append("\\n");
        case '\r' -> quoted.append("\\r");
        case '\t' -> quoted.append("\\t");
        default -> {
          if (c < FIRST_PRINTABLE || c == 0x7f) {
            quoted.append(String.format("\\u%04x", c));
          } else {
            quoted.append((char) c);
          }
        }
      }
    });
    return quoted.append('"').toString();
  }
}
