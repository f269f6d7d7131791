package org.robotui.headless.internal;

import java.util.Locale;

/** Writes one flat JSON object (RFC 8259) in one line. */
final class Json {
  private final StringBuilder text = new StringBuilder("{");

  Json put(String name, String value) {
    return raw(name, quote(value));
  }

  Json put(String name, long value) {
    return raw(name, Long.toString(value));
  }

  /** A number with fixed decimals; null where it is not finite, for which JSON has no word. */
  Json put(String name, double value, int decimals) {
    return raw(name, Double.isFinite(value) ? String.format(Locale.ROOT, "%." + decimals + "f", value) : "null");
  }

  String end() {
    return text + "}";
  }

  private Json raw(String name, String value) {
    if (text.length() > 1) {
      text.append(',');
    }
    text.append(quote(name)).append(':').append(value);
    return this;
  }

  static String quote(String value) {
    StringBuilder quoted = new StringBuilder(value.length() + 2).append('"');
    for (int i = 0; i < value.length(); i++) {
      escape(quoted, value, i);
    }
    return quoted.append('"').toString();
  }

  private static void escape(StringBuilder out, String value, int i) {
    char c = value.charAt(i);
    switch (c) {
      case '"' -> out.append("\\\"");
      case '\\' -> out.append("\\\\");
      case '\n' -> out.append("\\n");
      case '\r' -> out.append("\\r");
      case '\t' -> out.append("\\t");
      default -> {
        if (c < 0x20 || c == 0x7f || isLone(value, i)) {
          out.append(String.format("\\u%04x", (int) c));
        } else {
          out.append(c);
        }
      }
    }
  }

  /** Half a surrogate pair cannot be encoded as UTF-8. */
  private static boolean isLone(String value, int i) {
    char c = value.charAt(i);
    if (Character.isHighSurrogate(c)) {
      return i + 1 == value.length() || !Character.isLowSurrogate(value.charAt(i + 1));
    }
    return Character.isLowSurrogate(c) && (i == 0 || !Character.isHighSurrogate(value.charAt(i - 1)));
  }
}
