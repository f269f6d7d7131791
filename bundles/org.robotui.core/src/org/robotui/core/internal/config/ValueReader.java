package org.robotui.core.internal.config;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.Problem;
import org.robotui.api.input.Numerals;

/** Turns what is written into checked values; what does not fit becomes a problem that names the place. */
final class ValueReader {
  private final List<Problem> problems;

  ValueReader(List<Problem> problems) {
    this.problems = problems;
  }

  /** Reads a section by its schema, fallbacks filled in. */
  Settings settings(YamlValue.Section section, Schema schema) {
    Map<String, Object> values = new LinkedHashMap<>();
    for (YamlValue.Entry entry : section.entries()) {
      schema.find(entry.key()).ifPresentOrElse(s -> put(values, s, entry.value()), () -> unknown(entry, schema));
    }
    schema.settings().forEach(s -> fill(values, s, section));
    return new Settings(schema, values);
  }

  private void put(Map<String, Object> values, Setting setting, YamlValue value) {
    read(value, setting.type(), setting.name()).ifPresent(v -> values.put(setting.name(), v));
  }

  private void fill(Map<String, Object> values, Setting setting, YamlValue.Section section) {
    setting.fallback().ifPresent(f -> values.putIfAbsent(setting.name(), f));
    if (setting.required() && section.get(setting.name()).isEmpty()) {
      String what = "'" + setting.name() + "' is missing: " + setting.type().expected() + " (" + setting.help() + ")";
      problems.add(section.place().error(what));
    }
  }

  private void unknown(YamlValue.Entry entry, Schema schema) {
    List<String> names = schema.settings().stream().map(Setting::name).toList();
    String hint = names.isEmpty() ? "; there is nothing to set here" : NearestWord.hint(entry.key(), names);
    problems.add(entry.place().error("unknown setting '" + entry.key() + "'" + hint));
  }

  /** Reads one value of a type. */
  Optional<Object> read(YamlValue value, ValueType type, String name) {
    return switch (type) {
      case ValueType.Text t -> text(value, t, name);
      case ValueType.Flag f -> scalar(value).flatMap(ValueReader::flag).or(() -> wrong(value, type, name));
      case ValueType.Num n -> number(value, n, name);
      case ValueType.Int i -> integer(value, i, name);
      case ValueType.Choice c -> choice(value, c, name);
      case ValueType.ListOf l -> list(value, l, name);
      case ValueType.MapOf m -> map(value, m, name);
      case ValueType.Section s -> section(value, s, name);
      case ValueType.AnyOf a -> anyOf(value, a, name);
      case ValueType.Dependent d -> read(value, d.otherwise(), name);
      case ValueType.WithPlace p -> read(value, p.value(), name).map(v -> value.place().at(v));
    };
  }

  private Optional<Object> text(YamlValue value, ValueType.Text type, String name) {
    Optional<YamlValue.Scalar> scalar = scalar(value);
    if (scalar.isEmpty()) {
      return wrong(value, type, name);
    }
    String text = scalar.get().text();
    Optional<String> fault = type.fault(text);
    fault
        .ifPresent(f -> problems.add(value.place().error(mismatch(value, type, name) + (f.isEmpty() ? "" : "; " + f))));
    return fault.isEmpty() ? Optional.of(text) : Optional.empty();
  }

  private static Optional<YamlValue.Scalar> scalar(YamlValue value) {
    return value instanceof YamlValue.Scalar s && !s.isEmpty() ? Optional.of(s) : Optional.empty();
  }

  private static Optional<Object> flag(YamlValue.Scalar scalar) {
    return switch (scalar.plain() ? scalar.text() : "") {
      case "true", "yes", "on" -> Optional.of(true);
      case "false", "no", "off" -> Optional.of(false);
      default -> Optional.empty();
    };
  }

  private Optional<Object> number(YamlValue value, ValueType.Num type, String name) {
    return scalar(value).flatMap(s -> Numerals.decimal(s.text())).flatMap(type::fit).or(() -> wrong(value, type, name));
  }

  private Optional<Object> integer(YamlValue value, ValueType.Int type, String name) {
    return scalar(value).flatMap(s -> Numerals.whole(s.text())).filter(n -> n.bitLength() < Long.SIZE)
        .flatMap(type::fit).or(() -> wrong(value, type, name));
  }

  private Optional<Object> choice(YamlValue value, ValueType.Choice type, String name) {
    Optional<Object> word = scalar(value).map(YamlValue.Scalar::text).flatMap(type::fit);
    if (word.isEmpty()) {
      String hint = scalar(value).map(s -> NearestWord.hint(s.text(), type.words())).orElse("");
      problems.add(value.place().error(mismatch(value, type, name) + hint));
    }
    return word;
  }

  private Optional<Object> list(YamlValue value, ValueType.ListOf type, String name) {
    if (!(value instanceof YamlValue.Items items)) {
      return wrong(value, type, name);
    }
    List<Object> read = new ArrayList<>();
    items.items().forEach(item -> read(item, type.element(), name).ifPresent(read::add));
    return Optional.of(List.copyOf(read));
  }

  private Optional<Object> map(YamlValue value, ValueType.MapOf type, String name) {
    if (!(value instanceof YamlValue.Section section)) {
      return wrong(value, type, name);
    }
    Map<String, Object> read = new LinkedHashMap<>();
    section.entries()
        .forEach(e -> read(e.value(), type.value(), name + "." + e.key()).ifPresent(v -> read.put(e.key(), v)));
    return Optional.of(java.util.Collections.unmodifiableMap(read));
  }

  private Optional<Object> section(YamlValue value, ValueType.Section type, String name) {
    return value instanceof YamlValue.Section s ? Optional.of(settings(s, type.schema())) : wrong(value, type, name);
  }

  private Optional<Object> anyOf(YamlValue value, ValueType.AnyOf type, String name) {
    Optional<ValueType> text = type.alternatives().stream().filter(ValueType.Text.class::isInstance).findFirst();
    if (isQuoted(value) && text.isPresent()) {
      return read(value, text.get(), name);
    }
    for (ValueType alternative : type.alternatives()) {
      List<Problem> tried = new ArrayList<>();
      Optional<Object> read = new ValueReader(tried).read(value, alternative, name);
      if (tried.isEmpty()) {
        return read;
      }
    }
    return sameShape(value, type).flatMap(shape -> read(value, shape, name)).or(() -> anyWrong(value, type, name));
  }

  /** What stands in quotes is a text where it may be one: "007" and "#4da3ff" are no numbers. */
  private static boolean isQuoted(YamlValue value) {
    return value instanceof YamlValue.Scalar scalar && !scalar.plain();
  }

  /** The alternative of the same shape: its own problems say more than "none of these". */
  private static Optional<ValueType> sameShape(YamlValue value, ValueType.AnyOf type) {
    return type.alternatives().stream().filter(t -> hasShape(t, value)).findFirst();
  }

  private static boolean hasShape(ValueType type, YamlValue value) {
    return switch (type) {
      case ValueType.ListOf l -> value instanceof YamlValue.Items;
      case ValueType.MapOf m -> value instanceof YamlValue.Section;
      case ValueType.Section s -> value instanceof YamlValue.Section;
      case ValueType.AnyOf a -> a.alternatives().stream().anyMatch(t -> hasShape(t, value));
      case ValueType.Dependent d -> hasShape(d.otherwise(), value);
      case ValueType.WithPlace p -> hasShape(p.value(), value);
      case ValueType.Choice c -> value instanceof YamlValue.Scalar;
      case ValueType.Text t -> value instanceof YamlValue.Scalar scalar && !scalar.isEmpty();
      default -> false;
    };
  }

  private Optional<Object> anyWrong(YamlValue value, ValueType.AnyOf type, String name) {
    return sameShape(value, type).isPresent() ? Optional.empty() : wrong(value, type, name);
  }

  private Optional<Object> wrong(YamlValue value, ValueType type, String name) {
    problems.add(value.place().error(mismatch(value, type, name)));
    return Optional.empty();
  }

  private static String mismatch(YamlValue value, ValueType type, String name) {
    return "'" + name + "' must be " + type.expected() + ", not " + value.noun();
  }
}
