package org.robotui.bridge.internal.change;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.RecordTree;

/** Records as the arguments of calls. */
final class PlainArguments {
  /** What headers of ROS 1 have and those of ROS 2 do not; its value means nothing. */
  private static final String SEQUENCE = "seq";
  private static final List<String> HEADER = List.of("stamp", "frame_id");
  private static final double EXACT = 1L << 53;

  private PlainArguments() {}

  /** The fields of a record as numbers, truths, texts, lists and maps; times are nanoseconds. */
  static Map<String, Object> of(DynamicRecord record) {
    return members(RecordTree.of(record));
  }

  private static Map<String, Object> members(Map<?, ?> tree) {
    Map<String, Object> plain = new LinkedHashMap<>();
    boolean header = tree.keySet().containsAll(HEADER);
    tree.forEach((name, value) -> {
      if (!header || !name.equals(SEQUENCE)) {
        plain.put(name.toString(), plain(value));
      }
    });
    return plain;
  }

  private static Object plain(Object value) {
    return switch (value) {
      case Map<?, ?> tree -> members(tree);
      case List<?> list -> list.stream().map(PlainArguments::plain).toList();
      case double[] numbers -> Arrays.stream(numbers).mapToObj(PlainArguments::number).toList();
      default -> value;
    };
  }

  /** Whole numbers stay whole, as a field may hold no others. */
  private static Object number(double value) {
    return value == Math.rint(value) && Math.abs(value) < EXACT ? (Object) (long) value : value;
  }
}
