package org.robotui.uic.body.internal.model;

import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/** What fields hold, on one line. */
final class FieldWords {
  private static final int LONGEST = 200;
  private static final int EXACT_UNTIL = 11;
  private static final double WHOLE_UNTIL = 1e15;

  private FieldWords() {}

  static String of(FieldValue value) {
    return switch (value) {
      case FieldValue.Num num -> num.exact().length() <= EXACT_UNTIL ? num.exact() : number(num.value());
      case FieldValue.Flag flag -> String.valueOf(flag.value());
      case FieldValue.Text text -> brief(text.value());
      case FieldValue.Time time -> number(time.nanos() / 1e9) + " s";
      case FieldValue.Numbers numbers -> numbers.values().size() + " numbers";
      case FieldValue.Items items -> items.values().size() + " elements";
      case FieldValue.Nested nested -> of(nested.value());
    };
  }

  /** Its fields but those that are records. */
  static String of(DynamicRecord record) {
    return brief(record.fields().stream()
        .flatMap(name -> record.field(name).filter(v -> !(v instanceof FieldValue.Nested)).stream()
            .map(v -> name + " " + of(v)))
        .collect(Collectors.joining(", ")));
  }

  private static String brief(String text) {
    String line = text.length() > LONGEST ? text.substring(0, LONGEST) + "\u2026" : text;
    return line.replaceAll("\\s+", " ");
  }

  /** As many digits as matter to who looks: the fifth one of a degree is a metre. */
  static String number(double value) {
    if (value == Math.rint(value) && Math.abs(value) < WHOLE_UNTIL) {
      return String.valueOf((long) value);
    }
    double size = Math.abs(value);
    String pattern = size >= 1e6 || size < 1e-3 ? "%.4g" : size < 1 ? "%.4f" : size < 200 ? "%.5f" : "%.1f";
    return Double.isFinite(value) ? String.format(Locale.ROOT, pattern, value) : String.valueOf(value);
  }

  static OptionalDouble number(FieldValue value) {
    return value instanceof FieldValue.Num num && Double.isFinite(num.value()) ? OptionalDouble.of(num.value())
        : OptionalDouble.empty();
  }
}
