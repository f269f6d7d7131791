package org.robotui.bridge.internal.change;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.robotui.data.array.Doubles;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/** Records as the arguments of calls. */
public final class PlainArguments {
  /** What headers of ROS 1 have and those of ROS 2 do not; its value means nothing. */
  private static final String SEQUENCE = "seq";
  private static final List<String> HEADER = List.of("stamp", "frame_id");
  private static final double EXACT = 1L << 53;

  private PlainArguments() {}

  /** The fields of a record as numbers, truths, texts, lists and maps; times are nanoseconds. */
  public static Map<String, Object> of(DynamicRecord record) {
    Map<String, Object> plain = new LinkedHashMap<>();
    boolean header = record.fields().containsAll(HEADER);
    record.fields().stream().filter(name -> !header || !name.equals(SEQUENCE))
        .forEach(name -> record.field(name).ifPresent(value -> plain.put(name, plain(value))));
    return plain;
  }

  private static Object plain(FieldValue value) {
    return switch (value) {
      case FieldValue.Flag f -> f.value();
      case FieldValue.Num n -> number(n);
      case FieldValue.Text t -> t.value();
      case FieldValue.Time t -> t.nanos();
      case FieldValue.Numbers n -> numbers(n.values());
      case FieldValue.Items i -> i.values().stream().map(PlainArguments::plain).toList();
      case FieldValue.Nested n -> of(n.value());
    };
  }

  private static Object number(FieldValue.Num number) {
    try {
      return Long.parseLong(number.exact());
    } catch (NumberFormatException e) {
      return number(number.value());
    }
  }

  /** Whole numbers stay whole, as a field may hold no others. */
  private static Object number(double value) {
    return value == Math.rint(value) && Math.abs(value) < EXACT ? (Object) (long) value : value;
  }

  private static List<Object> numbers(Doubles values) {
    return IntStream.range(0, values.size()).mapToObj(i -> number(values.get(i))).toList();
  }
}
