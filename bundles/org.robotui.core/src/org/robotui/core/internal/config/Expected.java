package org.robotui.core.internal.config;

import java.util.stream.Collectors;
import org.robotui.api.config.ValueType;

/** Says in words what a setting may hold. */
final class Expected {
  /** From here on a number is written with an exponent. */
  private static final double MOST_DIGITS = 1e9;

  private Expected() {}

  static String of(ValueType type) {
    return switch (type) {
      case ValueType.Text t -> t.rule().expected();
      case ValueType.Flag f -> "true or false";
      case ValueType.Num n -> "a number" + limits(n) + (n.unit().isEmpty() ? "" : " in " + n.unit());
      case ValueType.Int i -> "a whole number from " + i.min() + " to " + i.max();
      case ValueType.Choice c -> "one of " + String.join(", ", c.words());
      case ValueType.ListOf l -> "a list, each element " + of(l.element());
      case ValueType.MapOf m -> "names with values, each " + of(m.value());
      case ValueType.Section s -> "a section";
      case ValueType.AnyOf a -> a.alternatives().stream().map(Expected::of).collect(Collectors.joining(", or "));
      case ValueType.WithPlace p -> of(p.value());
    };
  }

  static boolean hasShape(ValueType type, YamlValue value) {
    return switch (type) {
      case ValueType.ListOf l -> value instanceof YamlValue.Items;
      case ValueType.MapOf m -> value instanceof YamlValue.Section;
      case ValueType.Section s -> value instanceof YamlValue.Section;
      case ValueType.AnyOf a -> a.alternatives().stream().anyMatch(t -> hasShape(t, value));
      case ValueType.WithPlace p -> hasShape(p.value(), value);
      case ValueType.Choice c -> value instanceof YamlValue.Scalar;
      case ValueType.Text t -> value instanceof YamlValue.Scalar scalar && !scalar.isEmpty();
      default -> false;
    };
  }

  private static String limits(ValueType.Num n) {
    return " from " + plain(n.min()) + " to " + plain(n.max());
  }

  private static String plain(double number) {
    return number == Math.rint(number) && Math.abs(number) < MOST_DIGITS ? Long.toString((long) number) : Double.toString(number);
  }
}
