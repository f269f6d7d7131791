package org.robotui.ui.control;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Face;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/**
 * The headings of a table: a click sorts, a drag at an edge makes a column wider, a double-click there undoes it.
 * Display thread.
 */
final class TableHeader<R> {
  static final int HEIGHT = 24;

  private static final int GRIP = 4;
  private static final int ARROW = 7;

  private final PaintedCanvas canvas;
  private final Theme theme;
  private final List<Column<R>> columns;
  private final ColumnWidths widths;
  private final Runnable resized;
  private final Consumer<Column<R>> clicked;
  private Optional<RowOrder<R>> order = Optional.empty();
  private int[] edges = {0};
  private int grip = -1;
  private int hot = -1;
  private int pressed = -1;

  TableHeader(Composite parent, Theme theme, List<Column<R>> columns, ColumnWidths widths, Runnable resized,
      Consumer<Column<R>> clicked) {
    this.theme = theme;
    this.columns = columns;
    this.widths = widths;
    this.resized = resized;
    this.clicked = clicked;
    canvas = new PaintedCanvas(parent, SWT.NO_FOCUS, theme, Role.PANEL, this::paint);
    canvas.addListener(SWT.MouseDown, this::down);
    canvas.addListener(SWT.MouseUp, this::up);
    canvas.addListener(SWT.MouseMove, this::move);
    canvas.addListener(SWT.MouseExit, e -> hover(-1));
    canvas.addListener(SWT.MouseDoubleClick, this::doubled);
  }

  PaintedCanvas canvas() {
    return canvas;
  }

  void edges(int[] next) {
    edges = next;
    canvas.redraw();
  }

  void order(Optional<RowOrder<R>> next) {
    order = next;
    canvas.redraw();
  }

  private void paint(GC gc, Rectangle area) {
    for (int i = 0; i < columns.size() && i + 1 < edges.length; i++) {
      if (edges[i + 1] > edges[i]) {
        heading(gc, i, new Rectangle(edges[i], 0, edges[i + 1] - edges[i], area.height));
      }
    }
    gc.setForeground(theme.color(Role.LINE));
    gc.setLineWidth(1);
    gc.drawLine(0, area.height - 1, area.width, area.height - 1);
  }

  private void heading(GC gc, int index, Rectangle at) {
    Column<R> column = columns.get(index);
    boolean sorted = order.filter(o -> o.column() == column).isPresent();
    int room = at.width - 2 * CellPainter.PADDING - (sorted ? ARROW + Theme.STEP : 0);
    gc.setFont(theme.font(Face.SMALL));
    String title = TextFit.shorten(gc, column.title(), room);
    Point size = gc.textExtent(title);
    int x = column.right() ? at.x + at.width - CellPainter.PADDING - size.x : at.x + CellPainter.PADDING;
    gc.setForeground(theme.color(index == hot || sorted ? Role.TEXT : Role.DIM));
    gc.drawText(title, x, (at.height - size.y) / 2, true);
    if (sorted) {
      arrow(gc, column.right() ? x - ARROW - Theme.STEP : x + size.x + Theme.STEP, at.height / 2);
    }
    if (index > 0 && hot >= 0) {
      gc.setForeground(theme.color(Role.LINE));
      gc.drawLine(at.x, 2 * Theme.STEP - 2, at.x, at.height - 2 * Theme.STEP);
    }
  }

  private void arrow(GC gc, int x, int middle) {
    boolean down = order.filter(RowOrder::descending).isPresent();
    int tip = down ? middle + 2 : middle - 2;
    int base = down ? middle - 2 : middle + 2;
    gc.setBackground(theme.color(Role.ACCENT));
    gc.fillPolygon(new int[]{x, base, x + ARROW, base, x + ARROW / 2, tip});
  }

  private void down(Event event) {
    grip = gripAt(event.x);
    pressed = grip < 0 ? columnAt(event.x) : -1;
  }

  private void up(Event event) {
    int column = columnAt(event.x);
    if (event.button == 1 && pressed >= 0 && pressed == column && sortable(column)) {
      clicked.accept(columns.get(column));
    }
    grip = -1;
    pressed = -1;
  }

  private void move(Event event) {
    if (grip >= 0) {
      widths.drag(grip, event.x - edges[grip]);
      resized.run();
      return;
    }
    int cursor = gripAt(event.x) >= 0 ? SWT.CURSOR_SIZEWE : SWT.CURSOR_ARROW;
    canvas.setCursor(canvas.getDisplay().getSystemCursor(cursor));
    hover(columnAt(event.x));
  }

  private void doubled(Event event) {
    int column = gripAt(event.x);
    if (column >= 0) {
      widths.reset(column);
      resized.run();
    }
  }

  private void hover(int column) {
    if (hot != column) {
      hot = column;
      canvas.setToolTipText(column >= 0 && sortable(column) ? "Sort by " + columns.get(column).title() : null);
      canvas.redraw();
    }
  }

  private boolean sortable(int column) {
    return column >= 0 && columns.get(column).order().isPresent();
  }

  private int columnAt(int x) {
    for (int i = 0; i + 1 < edges.length; i++) {
      if (x >= edges[i] && x < edges[i + 1]) {
        return i;
      }
    }
    return -1;
  }

  /** The column whose right edge is there; the last one's is the table's own. */
  private int gripAt(int x) {
    for (int i = edges.length - 3; i >= 0; i--) {
      if (Math.abs(x - edges[i + 1]) <= GRIP && edges[i + 1] > edges[i]) {
        return i;
      }
    }
    return -1;
  }
}
