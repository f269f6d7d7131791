package org.robotui.rfic.xbot.internal.follow;

import java.util.List;
import java.util.Map;
import org.robotui.api.input.Numerals;

/**
 * Fields of a goal by name, as forms, scripts and bridges give them. What is not there is zero or empty.
 *
 * @param fields numbers, texts, lists, maps
 */
record GoalFields(Map<?, ?> fields) {
  private static final long SECOND = 1_000_000_000L;

  GoalFields inner(String name) {
    return switch (fields.get(name)) {
      case null -> new GoalFields(Map.of());
      case Map<?, ?> map -> new GoalFields(map);
      case Object other -> throw fault(name, other, "a record");
    };
  }

  List<GoalFields> list(String name) {
    return items(name).stream().map(each -> {
      if (each instanceof Map<?, ?> map) {
        return new GoalFields(map);
      }
      throw fault(name, each, "a record");
    }).toList();
  }

  List<String> texts(String name) {
    return items(name).stream().map(Object::toString).toList();
  }

  /** Numbers as the plugin reads them. */
  List<String> numbers(String name) {
    return items(name).stream().map(each -> Numerals.text(number(name, each))).toList();
  }

  private List<?> items(String name) {
    return switch (fields.get(name)) {
      case null -> List.of();
      case List<?> list -> list;
      case Object other -> throw fault(name, other, "a list");
    };
  }

  String text(String name) {
    return fields.get(name) instanceof Object there ? there.toString() : "";
  }

  double number(String name) {
    return fields.get(name) instanceof Object there ? number(name, there) : 0;
  }

  /** A time or a duration: nanoseconds, or parts as messages have them. */
  long nanos(String name) {
    return switch (fields.get(name)) {
      case null -> 0;
      case Number nanos -> nanos.longValue();
      case Map<?, ?> parts -> nanos(new GoalFields(parts));
      case Object other -> throw fault(name, other, "a time");
    };
  }

  private static long nanos(GoalFields parts) {
    return (long) (parts.number("sec") + parts.number("secs")) * SECOND
        + (long) (parts.number("nanosec") + parts.number("nsecs") + parts.number("nsec"));
  }

  private static double number(String name, Object value) {
    if (value instanceof Number number) {
      return number.doubleValue();
    }
    throw fault(name, value, "a number");
  }

  private static IllegalArgumentException fault(String name, Object value, String wanted) {
    return new IllegalArgumentException("'" + name + "' is " + wanted + ", not '" + value + "'");
  }
}
