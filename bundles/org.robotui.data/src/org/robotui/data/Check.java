package org.robotui.data;

/** Validation at construction: the message names the component and what is wrong with it. */
final class Check {
  private Check() {}

  static void that(boolean holds, String component, String message) {
    if (!holds) {
      throw new IllegalArgumentException(component + ": " + message);
    }
  }

  static void finite(double value, String component) {
    that(Double.isFinite(value), component, "must be finite, is " + value);
  }

  static void notNegative(double value, String component) {
    that(value >= 0, component, "must not be negative or NaN, is " + value);
  }

  static void sizeIs(int size, int expected, String component) {
    that(size == expected, component, "must have " + expected + " values, has " + size);
  }

  static void emptyOr(int size, int expected, String component) {
    that(size == 0 || size == expected, component, "must have none or " + expected + " values, has " + size);
  }
}
