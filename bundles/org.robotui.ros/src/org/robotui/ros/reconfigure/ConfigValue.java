package org.robotui.ros.reconfigure;

import java.util.Optional;

/** The value of one parameter. */
public sealed interface ConfigValue {

  /**
   * A truth value.
   *
   * @param value true or false
   */
  record Flag(boolean value) implements ConfigValue {}

  /**
   * An integer.
   *
   * @param value the number
   */
  record Whole(int value) implements ConfigValue {}

  /**
   * A float.
   *
   * @param value the number
   */
  record Real(double value) implements ConfigValue {}

  /**
   * A text.
   *
   * @param value the text
   */
  record Text(String value) implements ConfigValue {}

  /**
   * The value as a Java value.
   *
   * @return a {@link Boolean}, {@link Integer}, {@link Double} or {@link String}
   */
  default Object toJava() {
    return switch (this) {
      case Flag flag -> flag.value();
      case Whole whole -> whole.value();
      case Real real -> real.value();
      case Text text -> text.value();
    };
  }

  /**
   * Reads a Java value, as a form or a script gives it.
   *
   * @param kind what the parameter holds
   * @param value a {@link Boolean}, {@link Number} or {@link String}; texts of numbers and truth values are read
   * @return empty if the value is none of this kind
   */
  static Optional<ConfigValue> of(ConfigKind kind, Object value) {
    try {
      return switch (kind) {
        case FLAG -> flag(value);
        case WHOLE -> Optional.of(new Whole(Math.toIntExact(whole(value))));
        case REAL -> Optional
            .of(new Real(value instanceof Number number ? number.doubleValue() : Double.parseDouble(value.toString())));
        case TEXT -> value instanceof String text ? Optional.of(new Text(text)) : Optional.empty();
      };
    } catch (NumberFormatException | ArithmeticException e) {
      return Optional.empty();
    }
  }

  private static Optional<ConfigValue> flag(Object value) {
    return switch (value.toString()) {
      case "true", "True", "1" -> Optional.of(new Flag(true));
      case "false", "False", "0" -> Optional.of(new Flag(false));
      default -> Optional.empty();
    };
  }

  private static long whole(Object value) {
    if (value instanceof Double || value instanceof Float) {
      double real = ((Number) value).doubleValue();
      if (real != Math.rint(real) || Math.abs(real) > Integer.MAX_VALUE + 1.0) {
        throw new ArithmeticException(real + " is no whole number");
      }
      return (long) real;
    }
    return value instanceof Number number ? number.longValue() : Long.parseLong(value.toString().strip());
  }
}
