package org.robotui.message.payload;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.web.tree.JsonNull;

/** Trees of JSON as the values of others, and records as such trees. */
public final class JsonValues {
  private static final long SECOND = 1_000_000_000L;

  private JsonValues() {}

  /** The members, where null stands for a number that JSON has not. */
  static Map<String, Object> plain(Map<String, Object> members) {
    Map<String, Object> plain = new LinkedHashMap<>();
    members.forEach((name, value) -> plain.put(name, plain(value)));
    return plain;
  }

  private static Object plain(Object value) {
    return switch (value) {
      case JsonNull none -> Double.NaN;
      case Map<?, ?> members -> {
        Map<String, Object> plain = new LinkedHashMap<>();
        members.forEach((name, inner) -> plain.put(name.toString(), plain(inner)));
        yield plain;
      }
      case List<?> items -> items.stream().map(JsonValues::plain).toList();
      default -> value;
    };
  }

  /**
   * A tree in lists, as users of settings know it.
   *
   * @param value of a tree
   * @return Boolean, Long, Double, String, List or Map
   */
  public static Object listed(Object value) {
    return switch (value) {
      case long[] numbers -> LongStream.of(numbers).boxed().toList();
      case double[] numbers -> DoubleStream.of(numbers).boxed().toList();
      case List<?> items -> items.stream().map(JsonValues::listed).toList();
      case Map<?, ?> members -> {
        Map<String, Object> listed = new LinkedHashMap<>();
        members.forEach((name, inner) -> listed.put(name.toString(), listed(inner)));
        yield listed;
      }
      case JsonNull none -> "";
      default -> value;
    };
  }

  /**
   * A record as a tree.
   *
   * @param record what is written
   * @param rest how the part of a time below a second is called; seconds are {@code sec}
   * @return the tree
   */
  public static Map<String, Object> tree(DynamicRecord record, String rest) {
    Map<String, Object> members = new LinkedHashMap<>();
    for (String name : record.fields()) {
      record.field(name).ifPresent(value -> members.put(name, tree(value, rest)));
    }
    return members;
  }

  private static Object tree(FieldValue value, String rest) {
    return switch (value) {
      case FieldValue.Num number -> number(number);
      case FieldValue.Flag flag -> flag.value();
      case FieldValue.Text text -> text.value();
      case FieldValue.Time time -> Map.of("sec", Math.floorDiv(time.nanos(), SECOND), rest,
          Math.floorMod(time.nanos(), SECOND));
      case FieldValue.Numbers numbers -> numbers(numbers.values());
      case FieldValue.Items items -> {
        List<Object> all = new ArrayList<>();
        items.values().forEach(each -> all.add(tree(each, rest)));
        yield all;
      }
      case FieldValue.Nested nested -> tree(nested.value(), rest);
    };
  }

  /** Digits without a point are an integer. */
  private static Object number(FieldValue.Num number) {
    try {
      return Long.valueOf(number.exact());
    } catch (NumberFormatException e) {
      return number.value();
    }
  }

  private static double[] numbers(Doubles values) {
    double[] numbers = new double[values.size()];
    values.buffer().get(numbers);
    return numbers;
  }
}
