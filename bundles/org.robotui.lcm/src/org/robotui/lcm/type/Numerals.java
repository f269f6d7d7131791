package org.robotui.lcm.type;

import java.util.OptionalDouble;
import java.util.OptionalLong;

/** Numbers as C writes them: decimal, {@code 0x} hexadecimal, and octal after a zero. */
final class Numerals {

  private Numerals() {}

  static OptionalLong whole(String text) {
    if (!text.matches("[+-]?(0[xX][0-9a-fA-F]+|[0-9]+)")) {
      return OptionalLong.empty();
    }
    try {
      return OptionalLong.of(Long.decode(text));
    } catch (NumberFormatException e) {
      return OptionalLong.empty(); // too large, or no octal number
    }
  }

  static OptionalDouble real(String text) {
    if (text.matches("[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?")) {
      return OptionalDouble.of(Double.parseDouble(text));
    }
    OptionalLong whole = whole(text);
    return whole.isPresent() ? OptionalDouble.of(whole.getAsLong()) : OptionalDouble.empty();
  }
}
