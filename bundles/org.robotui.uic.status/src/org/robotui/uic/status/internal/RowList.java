package org.robotui.uic.status.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.dnd.Clipboard;
import org.eclipse.swt.dnd.TextTransfer;
import org.eclipse.swt.dnd.Transfer;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.ScrollBar;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;

/** A scrolled list of which only what is seen is painted. Display thread. */
final class RowList {
  /** A bar with less room than its ends need would be an error of the toolkit. */
  private static final int LOWEST_BAR = 2 * RowPainter.ROW;

  private final PaintedCanvas canvas;
  private final RowPainter painter;
  private final StateView states;
  private Optional<Look> look = Optional.empty();
  private List<Row> rows = List.of();
  private String filter = "";
  private Optional<String> marked = Optional.empty();
  private Runnable find = () -> { };

  RowList(Composite parent, Theme theme) {
    painter = new RowPainter(theme);
    states = new StateView(theme);
    canvas = new PaintedCanvas(parent, SWT.V_SCROLL, theme, Role.PANEL, this::paint);
    canvas.getVerticalBar().setVisible(false);
    canvas.getVerticalBar().addListener(SWT.Selection, e -> canvas.redraw());
    canvas.addListener(SWT.Resize, e -> fitBar());
    canvas.addListener(SWT.MouseDown, this::down);
    canvas.addListener(SWT.MouseMove, e -> tell(rowAt(e.y)));
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.FocusIn, e -> canvas.redraw());
    canvas.addListener(SWT.FocusOut, e -> canvas.redraw());
    canvas.addListener(SWT.Traverse, e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
  }

  Control control() {
    return canvas;
  }

  /** What the search key does. */
  void onFind(Runnable action) {
    find = action;
  }

  void show(Look next) {
    look = Optional.of(next);
    update();
  }

  void filter(String words) {
    filter = words;
    update();
  }

  private void update() {
    List<Row> next = look.map(l -> l.rows(filter)).orElse(List.of());
    boolean resized = next.size() != rows.size();
    rows = next;
    if (resized) {
      fitBar();
    }
    canvas.redraw();
  }

  private void fitBar() {
    ScrollBar bar = canvas.getVerticalBar();
    int seen = Math.max(1, canvas.getClientArea().height);
    int all = rows.size() * RowPainter.ROW;
    bar.setVisible(all > seen && seen >= LOWEST_BAR);
    bar.setValues(Math.clamp(bar.getSelection(), 0, Math.max(0, all - seen)), 0, Math.max(1, all), Math.min(seen, Math.max(1, all)),
        RowPainter.ROW, seen);
  }

  private int scrolled() {
    ScrollBar bar = canvas.getVerticalBar();
    return bar.getVisible() ? bar.getSelection() : 0;
  }

  private void paint(GC gc, Rectangle area) {
    Optional<Look.Trouble> trouble = look.flatMap(Look::trouble);
    if (trouble.isPresent()) {
      trouble.ifPresent(t -> states.message(gc, area, t.health(), t.title(), t.sentence()));
      return;
    }
    int first = scrolled() / RowPainter.ROW;
    int last = Math.min(rows.size(), (scrolled() + area.height) / RowPainter.ROW + 1);
    for (int i = first; i < last; i++) {
      Rectangle at = new Rectangle(area.x, area.y + i * RowPainter.ROW - scrolled(), area.width, RowPainter.ROW);
      painter.paint(gc, at, rows.get(i), marked.filter(rows.get(i).key()::equals).isPresent(), canvas.isFocusControl());
    }
  }

  private Optional<Row> rowAt(int y) {
    int index = Math.floorDiv(y + scrolled(), RowPainter.ROW);
    return index >= 0 && index < rows.size() ? Optional.of(rows.get(index)) : Optional.empty();
  }

  private void tell(Optional<Row> row) {
    String text = row.filter(r -> !(r instanceof Row.Head)).map(Row::details).map(d -> d.replace("&", "&&")).orElse("");
    if (!text.equals(canvas.getToolTipText())) {
      canvas.setToolTipText(text);
    }
  }

  private void down(Event event) {
    canvas.setFocus();
    rowAt(event.y).ifPresent(row -> mark(rows.indexOf(row)));
  }

  private void key(Event event) {
    int page = Math.max(1, canvas.getClientArea().height / RowPainter.ROW - 1);
    switch (event.keyCode) {
      case SWT.ARROW_UP -> mark(index() - 1);
      case SWT.ARROW_DOWN -> mark(index() + 1);
      case SWT.PAGE_UP -> mark(index() - page);
      case SWT.PAGE_DOWN -> mark(index() + page);
      case SWT.HOME -> mark(0);
      case SWT.END -> mark(rows.size() - 1);
      default -> shortcut(event);
    }
  }

  private void shortcut(Event event) {
    if ((event.stateMask & SWT.MOD1) != 0 && event.keyCode == 'c') {
      rows.stream().filter(row -> marked.filter(row.key()::equals).isPresent()).findFirst().ifPresent(this::copy);
    } else if ((event.stateMask & SWT.MOD1) != 0 && event.keyCode == 'f' || event.character == '/') {
      find.run();
    }
  }

  private void copy(Row row) {
    Clipboard clipboard = new Clipboard(canvas.getDisplay());
    clipboard.setContents(new Object[] {row.details()}, new Transfer[] {TextTransfer.getInstance()});
    clipboard.dispose();
  }

  private int index() {
    for (int i = 0; i < rows.size(); i++) {
      if (marked.filter(rows.get(i).key()::equals).isPresent()) {
        return i;
      }
    }
    return -1;
  }

  private void mark(int wanted) {
    if (!rows.isEmpty()) {
      int index = Math.clamp(wanted, 0, rows.size() - 1);
      marked = Optional.of(rows.get(index).key());
      reveal(index);
      canvas.redraw();
    }
  }

  private void reveal(int index) {
    int top = index * RowPainter.ROW;
    int seen = canvas.getClientArea().height;
    canvas.getVerticalBar().setSelection(Math.min(top, Math.max(scrolled(), top + RowPainter.ROW - seen)));
  }
}
