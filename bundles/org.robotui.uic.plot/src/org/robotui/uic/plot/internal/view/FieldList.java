package org.robotui.uic.plot.internal.view;

import java.util.List;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.dnd.DND;
import org.eclipse.swt.dnd.DragSource;
import org.eclipse.swt.dnd.DragSourceAdapter;
import org.eclipse.swt.dnd.DragSourceEvent;
import org.eclipse.swt.dnd.TextTransfer;
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
import org.robotui.uic.plot.internal.model.FieldTree;

/**
 * The tree of what could be plotted: arrows walk and open, enter or a double click adds, a drag takes along. Display
 * thread.
 */
final class FieldList {
  /** What is done with rows. */
  interface Hands {
    void toggle(FieldTree.Row row);

    void add(FieldTree.Row row);
  }

  private static final int ROW = 24;
  private static final int INDENT = 14;
  private static final int THUMB = 4;
  private static final int LEAST_DETAIL = 40;

  private final Theme theme;
  private final Hands hands;
  private final Runnable escaped;
  private final PaintedCanvas canvas;
  private List<FieldTree.Row> rows = List.of();
  private int marked;
  private int top;

  FieldList(Composite parent, Theme theme, Hands hands, Runnable escaped) {
    this.theme = theme;
    this.hands = hands;
    this.escaped = escaped;
    this.canvas = new PaintedCanvas(parent, theme, this::paint);
    canvas.addListener(SWT.MouseVerticalWheel, e -> scroll(top - e.count));
    canvas.addListener(SWT.MouseDown, this::press);
    canvas.addListener(SWT.MouseDoubleClick, e -> act(e.y));
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.FocusIn, e -> canvas.redraw());
    canvas.addListener(SWT.FocusOut, e -> canvas.redraw());
    canvas.addListener(SWT.Traverse,
        e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
    dragged();
  }

  PaintedCanvas control() {
    return canvas;
  }

  void focus() {
    canvas.setFocus();
  }

  void show(List<FieldTree.Row> next) {
    if (!rows.equals(next)) {
      rows = next;
      marked = Math.clamp(marked, 0, Math.max(0, rows.size() - 1));
      scroll(top);
    }
  }

  private int seen() {
    return Math.max(1, canvas.getClientArea().height / ROW);
  }

  private void scroll(int wanted) {
    top = Math.clamp(wanted, 0, Math.max(0, rows.size() - seen()));
    canvas.redraw();
  }

  private void mark(int index) {
    marked = Math.clamp(index, 0, Math.max(0, rows.size() - 1));
    scroll(Math.clamp(top, marked - seen() + 1, Math.max(marked - seen() + 1, marked)));
  }

  private void press(Event event) {
    canvas.setFocus();
    int index = top + event.y / ROW;
    if (index < rows.size()) {
      mark(index);
      FieldTree.Row row = rows.get(index);
      if (row.opens() && event.x < Theme.EDGE + (row.depth() + 1) * INDENT + Theme.STEP) {
        hands.toggle(row);
      }
    }
  }

  private void act(int y) {
    int index = top + y / ROW;
    if (index < rows.size()) {
      act(rows.get(index));
    }
  }

  private void act(FieldTree.Row row) {
    if (row.signals().isEmpty()) {
      hands.toggle(row);
    } else {
      hands.add(row);
    }
  }

  private void key(Event event) {
    if (event.keyCode == SWT.ESC) {
      escaped.run();
    } else if (!rows.isEmpty()) {
      walk(event);
    }
  }

  private void walk(Event event) {
    FieldTree.Row row = rows.get(marked);
    switch (event.keyCode) {
      case SWT.ARROW_DOWN -> mark(marked + 1);
      case SWT.ARROW_UP -> mark(marked - 1);
      case SWT.PAGE_DOWN -> mark(marked + seen());
      case SWT.PAGE_UP -> mark(marked - seen());
      case SWT.HOME -> mark(0);
      case SWT.END -> mark(rows.size() - 1);
      case SWT.ARROW_RIGHT -> toggle(row, false);
      case SWT.ARROW_LEFT -> toggle(row, true);
      case SWT.CR, SWT.KEYPAD_CR -> act(row);
      default -> {}
    }
  }

  private void toggle(FieldTree.Row row, boolean open) {
    if (row.opens() && row.open() == open) {
      hands.toggle(row);
    }
  }

  private void dragged() {
    DragSource source = new DragSource(canvas, DND.DROP_COPY);
    source.setTransfer(TextTransfer.getInstance());
    source.addDragListener(new DragSourceAdapter() {
      @Override
      public void dragStart(DragSourceEvent event) {
        event.doit = marked < rows.size() && !rows.get(marked).signals().isEmpty();
      }

      @Override
      public void dragSetData(DragSourceEvent event) {
        if (TextTransfer.getInstance().isSupportedType(event.dataType)) {
          event.data = String.join("\n", rows.get(marked).signals());
        }
      }
    });
  }

  private void paint(GC gc, Rectangle area) {
    for (int i = top; i < Math.min(rows.size(), top + seen() + 1); i++) {
      row(gc, new Rectangle(0, (i - top) * ROW, area.width, ROW), rows.get(i), i == marked);
    }
    if (rows.size() > seen()) {
      int length = Math.max(ROW, area.height * seen() / rows.size());
      int y = (area.height - length) * top / Math.max(1, rows.size() - seen());
      gc.setBackground(theme.mix(Role.DIM, Role.PANEL, 0.5));
      gc.fillRoundRectangle(area.width - THUMB - 2, y, THUMB, length, THUMB, THUMB);
    }
  }

  private void row(GC gc, Rectangle at, FieldTree.Row row, boolean isMarked) {
    if (isMarked) {
      gc.setBackground(theme.mix(Role.ACCENT, Role.PANEL, canvas.isFocusControl() ? 0.28 : 0.14));
      gc.fillRectangle(at);
    }
    int left = Theme.EDGE + row.depth() * INDENT;
    if (row.opens()) {
      arrow(gc, left, at.y + ROW / 2, row.open());
    }
    int x = left + INDENT;
    boolean title = row.depth() == 0;
    gc.setFont(theme.font(title ? Face.BODY_STRONG : Face.BODY));
    gc.setForeground(theme.color(row.signals().isEmpty() && !title ? Role.DIM : Role.TEXT));
    int right = at.width - Theme.EDGE;
    String name = TextFit.shorten(gc, row.name(), right - x);
    Point size = gc.textExtent(name);
    gc.drawText(name, x, at.y + (ROW - size.y) / 2, true);
    detail(gc, row, at.y, x + size.x + Theme.EDGE, right);
  }

  private void detail(GC gc, FieldTree.Row row, int y, int left, int right) {
    if (right - left >= LEAST_DETAIL) {
      gc.setFont(theme.font(row.signals().size() == 1 ? Face.SMALL_FIGURES : Face.SMALL));
      gc.setForeground(theme.color(Role.DIM));
      String text = TextFit.shorten(gc, row.detail(), right - left);
      Point size = gc.textExtent(text);
      gc.drawText(text, right - size.x, y + (ROW - size.y) / 2, true);
    }
  }

  private void arrow(GC gc, int x, int y, boolean open) {
    gc.setAntialias(SWT.ON);
    gc.setForeground(theme.color(Role.DIM));
    gc.setLineWidth(1);
    gc.drawPolyline(
        open ? new int[]{x, y - 2, x + 4, y + 2, x + 8, y - 2} : new int[]{x + 2, y - 4, x + 6, y, x + 2, y + 4});
  }

  /** Does something with the row that is marked. */
  void actOn(Consumer<FieldTree.Row> action) {
    if (marked < rows.size()) {
      action.accept(rows.get(marked));
    }
  }
}
