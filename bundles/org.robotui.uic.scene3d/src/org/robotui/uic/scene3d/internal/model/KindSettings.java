package org.robotui.uic.scene3d.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;

/**
 * The settings of a display, checked against the schema of its kind, which core does not know. What is wrong falls back and is said.
 *
 * @param settings checked, fallbacks included
 * @param problems sentences
 */
public record KindSettings(Settings settings, List<String> problems) {
  /** Copies the list. */
  public KindSettings {
    problems = List.copyOf(problems);
  }

  /** Checks what is written. */
  public static KindSettings check(Schema schema, Map<String, Object> written) {
    Map<String, Object> values = new LinkedHashMap<>();
    List<String> problems = new ArrayList<>();
    for (Setting setting : schema.settings()) {
      Optional<Object> given = Optional.ofNullable(written.get(setting.name()));
      Optional<Object> taken = given.flatMap(v -> take(setting.type(), v));
      taken.or(setting::fallback).or(() -> least(setting)).ifPresent(v -> values.put(setting.name(), v));
      if (given.isPresent() && taken.isEmpty()) {
        problems.add(setting.name() + " is " + given.get() + ", must be " + expected(setting.type()));
      }
    }
    written.keySet().stream().filter(name -> schema.find(name).isEmpty())
        .forEach(name -> problems.add("there is no setting '" + name + "'"));
    return new KindSettings(new Settings(schema, values), problems);
  }

  /** The value as settings hold it, or none where it does not fit. */
  public static Optional<Object> take(ValueType type, Object value) {
    return switch (type) {
      case ValueType.Text t -> Optional.of(value).filter(v -> v instanceof String || v instanceof Number).<Object>map(Object::toString)
          .filter(v -> t.rule().fault().apply(v.toString()).isEmpty());
      case ValueType.Flag f -> Optional.of(value).filter(Boolean.class::isInstance);
      case ValueType.Num n -> number(value).filter(v -> v >= n.min() && v <= n.max()).map(v -> v);
      case ValueType.Int i -> number(value).filter(v -> v == Math.rint(v) && v >= i.min() && v <= i.max()).map(Double::longValue);
      case ValueType.Choice c -> Optional.of(value).filter(c.words()::contains);
      case ValueType.ListOf l -> list(l, value);
      case ValueType.MapOf m -> Optional.of(value).filter(Map.class::isInstance);
      case ValueType.Section s -> Optional.of(value).map(v -> check(s.schema(), Written.fields(v)).settings());
      case ValueType.AnyOf any -> any.alternatives().stream().flatMap(a -> take(a, value).stream()).findFirst();
      case ValueType.WithPlace p -> take(p.value(), value).map(Placed::nowhere);
    };
  }

  /** What a value must be, in words. */
  public static String expected(ValueType type) {
    return switch (type) {
      case ValueType.Text t -> t.rule().expected();
      case ValueType.Flag f -> "true or false";
      case ValueType.Num n -> String.format(Locale.ROOT, "from %s to %s %s", n.min(), n.max(), n.unit()).strip();
      case ValueType.Int i -> "a whole number from " + i.min() + " to " + i.max();
      case ValueType.Choice c -> "one of " + String.join(", ", c.words());
      case ValueType.ListOf l -> "a list, each " + expected(l.element());
      case ValueType.MapOf m -> "values by name";
      case ValueType.Section s -> "a group";
      case ValueType.AnyOf any -> String.join(", or ", any.alternatives().stream().map(KindSettings::expected).toList());
      case ValueType.WithPlace p -> expected(p.value());
    };
  }

  private static Optional<Object> list(ValueType.ListOf type, Object value) {
    if (!(value instanceof List<?> list)) {
      return Optional.empty();
    }
    List<Object> taken = list.stream().flatMap(v -> take(type.element(), v).stream()).toList();
    return taken.size() == list.size() ? Optional.of(taken) : Optional.empty();
  }

  private static Optional<Double> number(Object value) {
    return value instanceof Number n ? Optional.of(n.doubleValue()) : Optional.empty();
  }

  /** Something for a setting that must be written, so that a display that was just added works. */
  private static Optional<Object> least(Setting setting) {
    if (!setting.required()) {
      return Optional.empty();
    }
    return Optional.of(least(setting.type()));
  }

  private static Object least(ValueType type) {
    return switch (type) {
      case ValueType.Flag f -> false;
      case ValueType.Num n -> Math.clamp(0.0, n.min(), n.max());
      case ValueType.Int i -> Math.clamp(0L, i.min(), i.max());
      case ValueType.Choice c -> c.words().getFirst();
      case ValueType.ListOf l -> List.of();
      case ValueType.MapOf m -> Map.of();
      case ValueType.Section s -> check(s.schema(), Map.of()).settings();
      case ValueType.Text t -> "";
      case ValueType.AnyOf any -> "";
      case ValueType.WithPlace p -> Placed.nowhere(least(p.value()));
    };
  }
}
