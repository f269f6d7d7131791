package org.robotui.ui.control;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;

/**
 * The lines of the tree of a record. What is open is kept by path, so that the next record of the type looks the same.
 * Only what is open is looked at, and long arrays come in pages of pages, so that an update costs what is seen. Pure.
 */
final class RecordRows {
  static final int PAGE = 100;

  private static final int OPEN_AT_FIRST = 2;

  /** Where opening all ends. */
  private static final int MANY = 2_000;

  private final Set<String> turned = new HashSet<>();
  private int open = OPEN_AT_FIRST;

  /** Opens what is closed, and the other way round. */
  void turn(String path) {
    if (!turned.remove(path)) {
      turned.add(path);
    }
  }

  void openAll() {
    turned.clear();
    open = Integer.MAX_VALUE;
  }

  void closeAll() {
    turned.clear();
    open = 0;
  }

  List<RecordRow> of(DynamicRecord record) {
    List<RecordRow> rows = new ArrayList<>();
    fields(record, "", 0, rows);
    return rows;
  }

  private void fields(DynamicRecord record, String path, int depth, List<RecordRow> rows) {
    for (String name : record.fields()) {
      String at = path.isEmpty() ? name : path + '.' + name;
      record.field(name).ifPresent(value -> add(RecordRow.of(at, depth, name, value), rows));
    }
  }

  private void add(RecordRow row, List<RecordRow> rows) {
    boolean opened = row.expandable() && isOpen(row, rows.size());
    rows.add(row.expanded(opened));
    if (opened) {
      inside(row, rows);
    }
  }

  private boolean isOpen(RecordRow row, int before) {
    boolean first = switch (row.value()) {
      case FieldValue.Nested n -> row.depth() < open && before < MANY;
      case FieldValue.Items i -> open == Integer.MAX_VALUE && !row.isPage() && before < MANY;
      default -> false;
    };
    return first != turned.contains(row.path());
  }

  private void inside(RecordRow row, List<RecordRow> rows) {
    switch (row.value()) {
      case FieldValue.Nested n -> fields(n.value(), row.path(), row.depth() + 1, rows);
      case FieldValue.Numbers n -> elements(row, n.values().size(), rows);
      case FieldValue.Items i -> elements(row, i.values().size(), rows);
      default -> {}
    }
  }

  private void elements(RecordRow row, int size, List<RecordRow> rows) {
    int from = row.from();
    int to = row.isPage() ? Math.min(row.to(), size) : size;
    int step = step(to - from);
    for (int i = from; i < to; i += step) {
      if (step == 1) {
        add(element(row, i), rows);
      } else {
        add(page(row, i, Math.min(to, i + step)), rows);
      }
    }
  }

  /** How many elements a line stands for, where at most a page of lines is wanted. */
  private static int step(int count) {
    int step = 1;
    while (count > (long) step * PAGE) {
      step *= PAGE;
    }
    return step;
  }

  private static RecordRow page(RecordRow row, int from, int to) {
    String name = "[" + from + ".." + (to - 1) + "]";
    return new RecordRow(row.fieldPath() + name, row.depth() + 1, name, row.value(), from, to, false);
  }

  private static RecordRow element(RecordRow row, int index) {
    String name = "[" + index + "]";
    return RecordRow.of(row.fieldPath() + name, row.depth() + 1, name, element(row.value(), index));
  }

  private static FieldValue element(FieldValue many, int index) {
    return switch (many) {
      // The digits are only made for what is painted.
      case FieldValue.Numbers n -> new FieldValue.Num(n.values().get(index), "");
      case FieldValue.Items i -> i.values().get(index);
      default -> many;
    };
  }
}
