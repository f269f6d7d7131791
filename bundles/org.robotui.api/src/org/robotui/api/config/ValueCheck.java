package org.robotui.api.config;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** Checks plain values against types of values, and says in words what would fit. */
final class ValueCheck {
  /** From here on a number is written with an exponent. */
  private static final double MOST_DIGITS = 1e9;

  private ValueCheck() {}

  static Optional<Object> fit(ValueType type, Object value) {
    return switch (type) {
      case ValueType.Text t -> text(value).filter(v -> t.fault(v).isEmpty()).map(v -> v);
      case ValueType.Flag f -> Optional.of(value).filter(Boolean.class::isInstance);
      case ValueType.Num n -> number(value).map(Number::doubleValue).filter(v -> v >= n.min() && v <= n.max())
          .map(v -> v);
      case ValueType.Int i -> number(value).flatMap(ValueCheck::whole).filter(v -> v >= i.min() && v <= i.max())
          .map(v -> v);
      case ValueType.Choice c -> Optional.of(value).filter(String.class::isInstance).filter(c.words()::contains);
      case ValueType.ListOf l -> value instanceof List<?> list ? list(l, list) : Optional.empty();
      case ValueType.MapOf m -> value instanceof Map<?, ?> map ? map(m, map) : Optional.empty();
      case ValueType.Section s -> value instanceof Map<?, ?> map ? section(s.schema(), map) : Optional.empty();
      case ValueType.AnyOf any -> any.alternatives().stream().flatMap(a -> fit(a, value).stream()).findFirst();
      case ValueType.Dependent d -> fit(d.otherwise(), value);
      case ValueType.WithPlace p -> fit(p.value(), value).map(Placed::nowhere);
    };
  }

  /** A number is a text as well, as it is in a file. */
  private static Optional<String> text(Object value) {
    return Optional.of(value).filter(v -> v instanceof String || v instanceof Number).map(Object::toString);
  }

  private static Optional<Number> number(Object value) {
    return value instanceof Number n ? Optional.of(n) : Optional.empty();
  }

  private static Optional<Long> whole(Number number) {
    boolean fraction =
        (number instanceof Double || number instanceof Float) && number.doubleValue() != number.longValue();
    return fraction ? Optional.empty() : Optional.of(number.longValue());
  }

  private static Optional<Object> list(ValueType.ListOf type, List<?> values) {
    List<Object> fitting = values.stream().flatMap(v -> fit(type.element(), v).stream()).toList();
    return fitting.size() == values.size() ? Optional.of(fitting) : Optional.empty();
  }

  private static Optional<Object> map(ValueType.MapOf type, Map<?, ?> values) {
    Map<String, Object> fitting = new LinkedHashMap<>();
    values.forEach((name, value) -> fit(type.value(), value).ifPresent(v -> fitting.put(name.toString(), v)));
    return fitting.size() == values.size() ? Optional.of(Collections.unmodifiableMap(fitting)) : Optional.empty();
  }

  private static Optional<Object> section(Schema schema, Map<?, ?> values) {
    Map<String, Object> fitting = new LinkedHashMap<>();
    values.forEach((name, value) -> schema.find(name.toString()).flatMap(s -> fit(s.type(), value))
        .ifPresent(v -> fitting.put(name.toString(), v)));
    boolean complete = schema.settings().stream().allMatch(s -> !s.required() || fitting.containsKey(s.name()));
    if (!complete || fitting.size() < values.size()) {
      return Optional.empty();
    }
    schema.settings().forEach(s -> s.fallback().ifPresent(f -> fitting.putIfAbsent(s.name(), f)));
    return Optional.of(new Settings(schema, fitting));
  }

  static String expected(ValueType type) {
    return switch (type) {
      case ValueType.Text t -> t.rule().expected();
      case ValueType.Flag f -> "true or false";
      case ValueType.Num n -> "a number from " + plain(n.min()) + " to " + plain(n.max())
          + (n.unit().isEmpty() ? "" : " in " + n.unit());
      case ValueType.Int i -> "a whole number from " + i.min() + " to " + i.max();
      case ValueType.Choice c -> "one of " + String.join(", ", c.words());
      case ValueType.ListOf l -> "a list, each element " + expected(l.element());
      case ValueType.MapOf m -> "names with values, each " + expected(m.value());
      case ValueType.Section s -> "a section";
      case ValueType.AnyOf a -> a.alternatives().stream().map(ValueCheck::expected)
          .collect(Collectors.joining(", or "));
      case ValueType.Dependent d -> expected(d.otherwise());
      case ValueType.WithPlace p -> expected(p.value());
    };
  }

  private static String plain(double number) {
    return number == Math.rint(number) && Math.abs(number) < MOST_DIGITS ? Long.toString((long) number)
        : Double.toString(number);
  }
}
