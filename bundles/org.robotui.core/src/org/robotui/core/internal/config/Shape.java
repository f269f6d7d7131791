package org.robotui.core.internal.config;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.Problem;

/** Takes values of an expected shape, or says what was expected. */
final class Shape {
  /** A plain number: what counts is how it stands to the others. */
  private static final ValueType WEIGHT = new ValueType.Num(0.01, 1000, "");

  private Shape() {}

  static Optional<YamlValue.Section> section(YamlValue value, String what, List<Problem> problems) {
    if (value instanceof YamlValue.Section s) {
      return Optional.of(s);
    }
    if (value instanceof YamlValue.Scalar s && s.isEmpty()) {
      return Optional.of(new YamlValue.Section(List.of(), s.place()));
    }
    return wrong(value, what, "a section of names and values", problems);
  }

  static Optional<String> text(YamlValue value, String what, List<Problem> problems) {
    return text(value, what, "a word", problems);
  }

  static Optional<String> text(YamlValue value, String what, String expected, List<Problem> problems) {
    return value instanceof YamlValue.Scalar s && !s.isEmpty() ? Optional.of(s.text())
        : wrong(value, what, expected, problems);
  }

  /** A share of the room, in relation to those beside it. */
  static Optional<Double> weight(YamlValue value, List<Problem> problems) {
    return new ValueReader(problems).read(value, WEIGHT, "weight").map(Double.class::cast);
  }

  /** A list of words, or one word as a short form. */
  static List<YamlValue> items(YamlValue value) {
    return value instanceof YamlValue.Items i ? i.items() : List.of(value);
  }

  static Optional<YamlValue> required(YamlValue.Section section, String key, String expected, List<Problem> problems) {
    Optional<YamlValue> value = section.get(key);
    if (value.isEmpty()) {
      problems.add(section.place().error("'" + key + "' is missing: " + expected));
    }
    return value;
  }

  static void onlyKeys(YamlValue.Section section, Collection<String> keys, String where, List<Problem> problems) {
    section.entries().stream()
        .filter(e -> !keys.contains(e.key()))
        .forEach(e -> problems
            .add(e.place().error("unknown word '" + e.key() + "' " + where + NearestWord.hint(e.key(), keys))));
  }

  private static <T> Optional<T> wrong(YamlValue value, String what, String expected, List<Problem> problems) {
    problems.add(value.place().error(what + " must be " + expected + ", not " + value.noun()));
    return Optional.empty();
  }
}
