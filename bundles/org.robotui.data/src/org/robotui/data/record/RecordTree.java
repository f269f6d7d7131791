package org.robotui.data.record;

import java.util.LinkedHashMap;
import java.util.Map;

/** Records as trees of plain Java values, as they are written in JSON. */
public final class RecordTree {
  private static final int DEEPEST = 30;

  private RecordTree() {}

  /**
   * A record with all that it has. Records within it are maps, many numbers are an array of {@code double}, other
   * values are lists, whole numbers are {@code Long} where they fit, times are numbers of nanoseconds. What is nested
   * deeper than 30 times is left out.
   *
   * @param record any record
   * @return values by the names of fields, in their order
   */
  public static Map<String, Object> of(DynamicRecord record) {
    return members(record, 0);
  }

  private static Map<String, Object> members(DynamicRecord record, int depth) {
    Map<String, Object> members = new LinkedHashMap<>();
    if (depth < DEEPEST) {
      record.fields().forEach(
          name -> record.field(name).ifPresent(value -> members.put(name, value(value, depth + 1))));
    }
    return members;
  }

  private static Object value(FieldValue value, int depth) {
    return switch (value) {
      case FieldValue.Num number -> exact(number);
      case FieldValue.Flag flag -> flag.value();
      case FieldValue.Text text -> text.value();
      case FieldValue.Time time -> time.nanos();
      case FieldValue.Numbers numbers -> numbers(numbers);
      case FieldValue.Items items -> items.values().stream().map(each -> value(each, depth)).toList();
      case FieldValue.Nested nested -> members(nested.value(), depth);
    };
  }

  /** Whole numbers beyond what a double has exactly. */
  private static Object exact(FieldValue.Num number) {
    try {
      return Long.parseLong(number.exact());
    } catch (NumberFormatException e) {
      return number.value();
    }
  }

  private static double[] numbers(FieldValue.Numbers numbers) {
    double[] values = new double[numbers.values().size()];
    for (int i = 0; i < values.length; i++) {
      values[i] = numbers.values().get(i);
    }
    return values;
  }
}
