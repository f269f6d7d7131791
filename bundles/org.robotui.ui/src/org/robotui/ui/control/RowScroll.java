package org.robotui.ui.control;

import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.ScrollBar;
import org.eclipse.swt.widgets.Scrollable;

/** What part of many rows of equal height is seen. Display thread. */
final class RowScroll {
  private final Scrollable control;
  private final ScrollBar bar;
  private final int row;
  private int rows;

  /** A bar without room for its ends would be an error of the toolkit. */
  private final int lowest;

  RowScroll(Scrollable control, int rowHeight, Runnable scrolled) {
    this.control = control;
    this.bar = control.getVerticalBar();
    this.row = rowHeight;
    this.lowest = 2 * rowHeight;
    bar.setVisible(false);
    bar.addListener(SWT.Selection, e -> scrolled.run());
  }

  void rows(int count) {
    if (count != rows) {
      rows = count;
      fit();
    }
  }

  /** Fits the bar to rows and room. */
  void fit() {
    int room = Math.max(1, room());
    int all = (int) Math.clamp((long) rows * row, 1, Integer.MAX_VALUE / 2);
    boolean wanted = all > room && room >= lowest;
    if (bar.getVisible() != wanted) {
      bar.setVisible(wanted);
    }
    bar.setValues(Math.clamp(bar.getSelection(), 0, Math.max(0, all - room)), 0, all, Math.min(room, all), row, room);
  }

  int offset() {
    return bar.getVisible() ? bar.getSelection() : 0;
  }

  void offset(int points) {
    bar.setSelection(points);
  }

  int room() {
    return control.getClientArea().height;
  }

  int page() {
    return Math.max(1, room() / row - 1);
  }

  int first() {
    return offset() / row;
  }

  /** The first row that is not seen. */
  int end() {
    return Math.min(rows, (offset() + room() + row - 1) / row);
  }

  int indexAt(int y) {
    int index = Math.floorDiv(y + offset(), row);
    return index >= 0 && index < rows ? index : -1;
  }

  int top(int index) {
    return index * row - offset();
  }

  boolean atEnd() {
    return offset() + room() >= rows * row - row / 2;
  }

  void toEnd() {
    bar.setSelection(Math.max(0, rows * row - room()));
  }

  void reveal(int index) {
    int top = index * row;
    bar.setSelection(Math.min(top, Math.max(offset(), top + row - room())));
  }
}
