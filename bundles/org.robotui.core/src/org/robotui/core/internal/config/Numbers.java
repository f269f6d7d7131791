package org.robotui.core.internal.config;

import java.util.Optional;
import java.util.regex.Pattern;

/** Reads numbers as people write them: not all that Java takes for one, such as {@code 1d}, and not infinity. */
final class Numbers {
  private static final Pattern DECIMAL = Pattern.compile("[-+]?(\\d+(\\.\\d*)?|\\.\\d+)([eE][-+]?\\d+)?");
  /** Not with zeros in front: what is meant by 010 is 8 for some, and 10 for others. */
  private static final Pattern WHOLE = Pattern.compile("[-+]?(0|[1-9]\\d*|0x[0-9a-fA-F]+)");

  private Numbers() {}

  /** A finite number. */
  static Optional<Double> decimal(String text) {
    return DECIMAL.matcher(text).matches() ? Optional.of(Double.valueOf(text)).filter(Double::isFinite)
        : Optional.empty();
  }

  /** A whole number of 64 bits. */
  static Optional<Long> whole(String text) {
    try {
      return WHOLE.matcher(text).matches() ? Optional.of(Long.decode(text)) : Optional.empty();
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }
}
