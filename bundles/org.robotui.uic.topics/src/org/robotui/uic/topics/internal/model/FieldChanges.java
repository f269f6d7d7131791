package org.robotui.uic.topics.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.uic.topics.internal.model.MessageContent.FieldChange;

/** Compares two messages field by field. Pure. */
final class FieldChanges {
  /** Of arrays so many elements are compared one by one, and of a message so many fields. */
  static final int MOST = 2_000;

  private FieldChanges() {}

  /** What differs, in the order of the fields; of too many fields the first ones. */
  static List<FieldChange> of(DynamicRecord before, DynamicRecord now) {
    Map<String, String> old = leaves(before);
    Map<String, String> fresh = leaves(now);
    List<FieldChange> changes = new ArrayList<>();
    fresh.forEach((path, value) -> {
      String former = old.getOrDefault(path, "");
      if (!former.equals(value)) {
        changes.add(new FieldChange(path, former, value));
      }
    });
    old.forEach((path, value) -> {
      if (!fresh.containsKey(path)) {
        changes.add(new FieldChange(path, value, ""));
      }
    });
    return List.copyOf(changes);
  }

  private static Map<String, String> leaves(DynamicRecord record) {
    Map<String, String> leaves = new LinkedHashMap<>();
    record("", record, leaves);
    return leaves;
  }

  private static void record(String path, DynamicRecord record, Map<String, String> into) {
    String prefix = path.isEmpty() ? "" : path + ".";
    record.fields().forEach(name -> record.field(name).ifPresent(value -> value(prefix + name, value, into)));
  }

  private static void value(String path, FieldValue value, Map<String, String> into) {
    if (into.size() >= MOST) {
      return;
    }
    switch (value) {
      case FieldValue.Num number -> into.put(path, number.exact());
      case FieldValue.Flag flag -> into.put(path, Boolean.toString(flag.value()));
      case FieldValue.Text text -> into.put(path, text.value());
      case FieldValue.Time time -> into.put(path, time.nanos() / 1_000_000_000L + "."
          + String.format("%09d", Math.floorMod(time.nanos(), 1_000_000_000L)));
      case FieldValue.Numbers numbers -> {
        into.put(path + ".length", Integer.toString(numbers.values().size()));
        for (int i = 0; i < Math.min(numbers.values().size(), MOST); i++) {
          into.put(path + "[" + i + "]", Double.toString(numbers.values().get(i)));
        }
      }
      case FieldValue.Items items -> {
        into.put(path + ".length", Integer.toString(items.values().size()));
        for (int i = 0; i < items.values().size(); i++) {
          value(path + "[" + i + "]", items.values().get(i), into);
        }
      }
      case FieldValue.Nested nested -> record(path, nested.value(), into);
    }
  }
}
