package org.robotui.ui.show;

import java.util.ArrayList;
import java.util.List;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/** The numbers within a value, by their paths: what can be plotted of it. Any thread. */
public final class NumberPaths {
  private static final int MOST = 60;
  private static final int SHORT_LIST = 12;
  private static final int DEEPEST = 8;
  private static final String HEADER = "header";

  private final List<String> paths = new ArrayList<>();

  private NumberPaths() {}

  /**
   * Finds the numbers and truth values. Long lists and headers are left out; of very large values so is all that comes
   * after the first sixty.
   *
   * @param record a value
   * @return paths such as {@code linear.x} or {@code joints[0].position}, in the order of the fields
   */
  public static List<String> of(DynamicRecord record) {
    NumberPaths found = new NumberPaths();
    found.record("", record, 0);
    return List.copyOf(found.paths);
  }

  /**
   * Finds the numbers and truth values within a field.
   *
   * @param path of the field
   * @param value what it holds
   * @return the path itself where it holds a number
   */
  public static List<String> at(String path, FieldValue value) {
    NumberPaths found = new NumberPaths();
    found.value(path, value, 0);
    return List.copyOf(found.paths);
  }

  private void record(String prefix, DynamicRecord record, int depth) {
    for (String name : record.fields()) {
      if (paths.size() < MOST && depth < DEEPEST && !name.equals(HEADER)) {
        record.field(name).ifPresent(value -> value(prefix + name, value, depth));
      }
    }
  }

  private void value(String path, FieldValue value, int depth) {
    switch (value) {
      case FieldValue.Num n -> add(path);
      case FieldValue.Flag f -> add(path);
      case FieldValue.Nested n -> record(path + ".", n.value(), depth + 1);
      case FieldValue.Numbers n when n.values().size() <= SHORT_LIST -> {
        for (int i = 0; i < n.values().size(); i++) {
          add(path + "[" + i + "]");
        }
      }
      case FieldValue.Items items when items.values().size() <= SHORT_LIST -> {
        for (int i = 0; i < items.values().size(); i++) {
          value(path + "[" + i + "]", items.values().get(i), depth + 1);
        }
      }
      default -> {}
    }
  }

  private void add(String path) {
    if (paths.size() < MOST) {
      paths.add(path);
    }
  }
}
