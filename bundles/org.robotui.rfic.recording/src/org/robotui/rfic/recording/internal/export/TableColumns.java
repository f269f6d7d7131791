package org.robotui.rfic.recording.internal.export;

import java.util.List;
import org.robotui.data.record.FieldValue;

/** The columns of a table of messages. Filled by one thread, then read. */
final class TableColumns {
  /** Elements of an array that have a column of their own. */
  static final int MOST_ELEMENTS = 512;
  private static final int MOST_COLUMNS = 10_000;

  private final ColumnBudget budget = new ColumnBudget(MOST_COLUMNS);
  private final ColumnNode root = new ColumnNode(budget);

  void learn(FieldValue message) {
    root.learn(message);
  }

  void names(List<String> into) {
    root.names("", into);
  }

  void cells(FieldValue message, List<String> into) {
    root.cells(message, into);
  }

  String note() {
    if (budget.isSpent()) {
      return "only the first " + MOST_COLUMNS + " columns";
    }
    return budget.isCut() ? "of arrays the first " + MOST_ELEMENTS + " elements; --format jsonl writes all" : "";
  }

  /** How many columns there may be yet. */
  static final class ColumnBudget {
    private int left;
    private boolean spent;
    private boolean cut;

    ColumnBudget(int most) {
      left = most;
    }

    boolean take() {
      if (left == 0) {
        spent = true;
        return false;
      }
      left--;
      return true;
    }

    boolean isSpent() {
      return spent;
    }

    boolean isCut() {
      return cut;
    }

    void cut() {
      cut = true;
    }
  }
}
