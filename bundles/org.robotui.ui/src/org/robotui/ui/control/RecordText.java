package org.robotui.ui.control;

import java.math.BigDecimal;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/** Values of records as words. Pure. */
final class RecordText {
  private static final int SEEN = 8;
  private static final int LONGEST = 200_000;
  private static final long NANOS = 1_000_000_000L;
  private static final double WHOLE_UNTIL = 1e15;

  private RecordText() {}

  /** A value in one line; of what holds others, what is to be known before it is opened. */
  static String line(FieldValue value) {
    return switch (value) {
      case FieldValue.Num n -> number(n);
      case FieldValue.Flag f -> Boolean.toString(f.value());
      case FieldValue.Text t -> t.value();
      case FieldValue.Time t -> seconds(t.nanos());
      case FieldValue.Numbers n -> numbers(n);
      case FieldValue.Items i -> items(i);
      case FieldValue.Nested n -> n.value().schema();
    };
  }

  static String line(RecordRow row) {
    return row.isPage() ? "" : line(row.value());
  }

  /**
   * A number as one would write it: whole ones without a point, single precision ones without the digits of double
   * precision.
   */
  static String number(double value) {
    if (value == Math.rint(value) && Math.abs(value) < WHOLE_UNTIL) {
      return Long.toString((long) value);
    }
    return (double) (float) value == value ? Float.toString((float) value) : Double.toString(value);
  }

  /** Seconds with nanoseconds. */
  static String seconds(long nanos) {
    return BigDecimal.valueOf(nanos, 9).toPlainString();
  }

  /** Seconds as they are typed, without zeros at the end. */
  static String shortSeconds(long nanos) {
    return nanos % NANOS == 0 ? Long.toString(nanos / NANOS)
        : BigDecimal.valueOf(nanos, 9).stripTrailingZeros().toPlainString();
  }

  /** A value over many lines, as tools of robots print it, cut where it is very long. */
  static String full(FieldValue value) {
    StringBuilder text = new StringBuilder();
    full(value, "", text);
    return text.length() < LONGEST ? text.toString().strip() : text.substring(0, LONGEST) + "\n\u2026";
  }

  private static void full(FieldValue value, String indent, StringBuilder text) {
    if (text.length() > LONGEST) {
      return;
    }
    switch (value) {
      case FieldValue.Nested n -> record(n.value(), indent, text);
      case FieldValue.Items i -> i.values().forEach(item -> item(item, indent, text));
      case FieldValue.Numbers n -> text.append('[').append(list(n, n.values().size())).append("]\n");
      default -> text.append(line(value)).append('\n');
    }
  }

  private static void record(DynamicRecord record, String indent, StringBuilder text) {
    for (String name : record.fields()) {
      record.field(name).ifPresent(value -> {
        text.append(indent).append(name).append(opens(value) ? ":\n" : ": ");
        full(value, indent + "  ", text);
      });
    }
  }

  private static void item(FieldValue item, String indent, StringBuilder text) {
    text.append(indent).append(opens(item) ? "-\n" : "- ");
    full(item, indent + "  ", text);
  }

  private static boolean opens(FieldValue value) {
    return value instanceof FieldValue.Nested || value instanceof FieldValue.Items;
  }

  private static String number(FieldValue.Num number) {
    return number.exact().isEmpty() ? number(number.value()) : number.exact();
  }

  private static String numbers(FieldValue.Numbers numbers) {
    int size = numbers.values().size();
    return sized(size, list(numbers, Math.min(SEEN, size)));
  }

  private static String list(FieldValue.Numbers numbers, int count) {
    return IntStream.range(0, count).mapToObj(i -> number(numbers.values().get(i))).collect(Collectors.joining(", "));
  }

  private static String items(FieldValue.Items items) {
    String begin = items.values().stream().limit(SEEN).filter(item -> !opens(item)).map(RecordText::line)
        .collect(Collectors.joining(", "));
    return sized(items.values().size(), begin);
  }

  private static String sized(int size, String begin) {
    String count = "[" + size + "]";
    if (begin.isEmpty()) {
      return count;
    }
    return count + "  " + begin + (size > SEEN ? ", \u2026" : "");
  }
}
