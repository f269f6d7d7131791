package org.robotui.rfic.recording.internal.export;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.rfic.recording.internal.export.TableColumns.ColumnBudget;

/**
 * Where a value can be in messages: it has a column of its own, or its members and elements have some. An array that is
 * cut has a column that says how long it is.
 */
final class ColumnNode {
  private static final String SECONDS = " [s]";

  private final ColumnBudget budget;
  private final Map<String, ColumnNode> members = new LinkedHashMap<>();
  private final List<ColumnNode> elements = new ArrayList<>();
  private boolean single;
  private boolean time;
  private boolean cut;

  ColumnNode(ColumnBudget budget) {
    this.budget = budget;
  }

  void learn(FieldValue value) {
    switch (value) {
      case FieldValue.Nested nested -> members(nested.value());
      case FieldValue.Numbers numbers -> {
        grow(numbers.values().size());
        elements.forEach(each -> each.becomeSingle(false));
      }
      case FieldValue.Items items -> {
        grow(items.values().size());
        for (int i = 0; i < Math.min(elements.size(), items.values().size()); i++) {
          elements.get(i).learn(items.values().get(i));
        }
      }
      default -> becomeSingle(value instanceof FieldValue.Time);
    }
  }

  private void members(DynamicRecord record) {
    for (String name : record.fields()) {
      Optional<FieldValue> value = record.field(name);
      if (value.isPresent() && (members.containsKey(name) || budget.take())) {
        members.computeIfAbsent(name, any -> new ColumnNode(budget)).learn(value.get());
      }
    }
  }

  private void becomeSingle(boolean isTime) {
    single = true;
    time |= isTime;
  }

  private void grow(int size) {
    if (size > TableColumns.MOST_ELEMENTS) {
      cut = true;
      budget.cut();
    }
    while (elements.size() < Math.min(size, TableColumns.MOST_ELEMENTS) && budget.take()) {
      elements.add(new ColumnNode(budget));
    }
  }

  void names(String path, List<String> into) {
    if (single) {
      into.add(path + (time ? SECONDS : ""));
    }
    if (cut) {
      into.add(path + ".length");
    }
    members.forEach((name, node) -> node.names(path.isEmpty() ? name : path + "." + name, into));
    for (int i = 0; i < elements.size(); i++) {
      elements.get(i).names(path + "[" + i + "]", into);
    }
  }

  /** The values of a message in the order of the names; what it does not have is empty. */
  void cells(FieldValue value, List<String> into) {
    cells(Optional.of(value), into);
  }

  private void cells(Optional<FieldValue> value, List<String> into) {
    if (single) {
      into.add(value.map(ColumnNode::text).orElse(""));
    }
    if (cut) {
      into.add(value.map(ColumnNode::length).orElse(""));
    }
    Optional<DynamicRecord> record =
        value.filter(FieldValue.Nested.class::isInstance).map(each -> ((FieldValue.Nested) each).value());
    members.forEach((name, node) -> node.cells(record.flatMap(each -> each.field(name)), into));
    for (int i = 0; i < elements.size(); i++) {
      elements.get(i).cells(element(value, i), into);
    }
  }

  private static Optional<FieldValue> element(Optional<FieldValue> value, int index) {
    return value.flatMap(each -> switch (each) {
      case FieldValue.Numbers numbers when index < numbers.values().size() -> Optional
          .of(number(numbers.values().get(index)));
      case FieldValue.Items items when index < items.values().size() -> Optional.of(items.values().get(index));
      default -> Optional.empty();
    });
  }

  private static FieldValue number(double value) {
    boolean whole = value == Math.rint(value) && Math.abs(value) < 1L << 53;
    return new FieldValue.Num(value, whole ? Long.toString((long) value) : Double.toString(value));
  }

  private static String text(FieldValue value) {
    return switch (value) {
      case FieldValue.Num number -> number.exact();
      case FieldValue.Flag flag -> Boolean.toString(flag.value());
      case FieldValue.Text text -> text.value();
      case FieldValue.Time moment -> MessageLines.seconds(moment.nanos());
      default -> "";
    };
  }

  private static String length(FieldValue value) {
    return switch (value) {
      case FieldValue.Numbers numbers -> Integer.toString(numbers.values().size());
      case FieldValue.Items items -> Integer.toString(items.values().size());
      default -> "";
    };
  }
}
