package org.robotui.uic.sound.internal.alert;

import java.util.Optional;

/** Reads numbers. */
final class Numbers {
  private Numbers() {}

  static Optional<Double> parse(String text) {
    try {
      return Optional.of(Double.parseDouble(text));
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }
}
