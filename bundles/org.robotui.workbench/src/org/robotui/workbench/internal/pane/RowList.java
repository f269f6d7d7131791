package org.robotui.workbench.internal.pane;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.accessibility.ACC;
import org.eclipse.swt.accessibility.AccessibleAdapter;
import org.eclipse.swt.accessibility.AccessibleControlAdapter;
import org.eclipse.swt.accessibility.AccessibleControlEvent;
import org.eclipse.swt.accessibility.AccessibleEvent;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * A painted list of rows of equal height. It is redrawn only when a row changed. Display thread only.
 *
 * @param <R> a row, with equals
 */
abstract class RowList<R> extends Canvas {
  private final Theme theme;
  private final int rowHeight;
  private List<R> rows = List.of();
  private int pointed = -1;
  private int hot = -1;

  RowList(Composite parent, Theme theme, int rowHeight) {
    super(parent, SWT.DOUBLE_BUFFERED | SWT.NO_BACKGROUND);
    this.theme = theme;
    this.rowHeight = rowHeight;
    setBackground(theme.color(Role.PANEL));
    addPaintListener(e -> paint(e.gc));
    addListener(SWT.MouseMove, e -> hot(indexAt(e.y)));
    addListener(SWT.MouseExit, e -> hot(-1));
    addListener(SWT.KeyDown, this::arrows);
    addListener(SWT.FocusIn, e -> point(Math.max(0, pointed)));
    addListener(SWT.FocusOut, e -> redraw());
    addListener(SWT.Traverse, e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
    describe();
  }

  /** Measures what all rows share, before they are painted. */
  void prepare(GC gc, int width) {
    // Most lists share nothing.
  }

  /** Paints one row; the background is there. */
  abstract void paintRow(GC gc, R row, int top, int width);

  /** What a screen reader says of a row. */
  abstract String spoken(R row);

  /** The tooltip of a row. */
  abstract String hint(R row);

  /** How wide a text is, pixels; the font is set afterwards. */
  final int width(GC gc, Face face, String text) {
    gc.setFont(theme.font(face));
    return gc.textExtent(text).x;
  }

  final void show(List<R> next) {
    if (!rows.equals(next)) {
      boolean resized = rows.size() != next.size();
      rows = List.copyOf(next);
      if (resized) {
        getParent().layout(true);
      }
      hint();
      redraw();
    }
  }

  final List<R> rows() {
    return rows;
  }

  final Theme theme() {
    return theme;
  }

  final Optional<R> at(int y) {
    int index = indexAt(y);
    return index < 0 ? Optional.empty() : Optional.of(rows.get(index));
  }

  final Optional<R> pointed() {
    return pointed >= 0 && pointed < rows.size() ? Optional.of(rows.get(pointed)) : Optional.empty();
  }

  /**
   * The row that a context menu is asked for: by key the one that has the focus, by mouse the one below the pointer.
   */
  final Optional<R> meant(Event menuDetect) {
    return menuDetect.detail == SWT.MENU_KEYBOARD ? pointed() : at(toControl(menuDetect.x, menuDetect.y).y);
  }

  final void point(int index) {
    pointed = Math.clamp(index, -1, rows.size() - 1);
    redraw();
  }

  @Override
  public Point computeSize(int widthHint, int heightHint, boolean changed) {
    return new Point(widthHint == SWT.DEFAULT ? 200 : widthHint, rows.size() * rowHeight);
  }

  private int indexAt(int y) {
    int index = Math.floorDiv(y, rowHeight);
    return index < rows.size() ? index : -1;
  }

  private void hot(int index) {
    if (hot != index) {
      hot = index;
      hint();
      redraw();
    }
  }

  private void hint() {
    String text = hot >= 0 && hot < rows.size() ? hint(rows.get(hot)) : null;
    if (!Objects.equals(text, getToolTipText())) {
      setToolTipText(text);
    }
  }

  private void arrows(Event event) {
    if (event.keyCode == SWT.ARROW_DOWN) {
      point(Math.min(pointed + 1, rows.size() - 1));
    } else if (event.keyCode == SWT.ARROW_UP) {
      point(Math.max(pointed - 1, 0));
    }
  }

  private void paint(GC gc) {
    Point size = getSize();
    gc.setBackground(theme.color(Role.PANEL));
    gc.fillRectangle(0, 0, size.x, size.y);
    gc.setTextAntialias(SWT.ON);
    prepare(gc, size.x);
    for (int i = 0; i < rows.size(); i++) {
      paintGround(gc, i, size.x);
      paintRow(gc, rows.get(i), i * rowHeight, size.x);
    }
  }

  private void paintGround(GC gc, int index, int width) {
    boolean focus = index == pointed && isFocusControl();
    if (index == hot || focus) {
      gc.setBackground(theme.mix(Role.TEXT, Role.PANEL, 0.05));
      gc.fillRectangle(0, index * rowHeight, width, rowHeight);
    }
    if (focus) {
      gc.setForeground(theme.color(Role.ACCENT));
      gc.setLineWidth(1);
      gc.drawRectangle(0, index * rowHeight, width - 1, rowHeight - 1);
    }
    gc.setFont(theme.font(Face.BODY));
  }

  private void describe() {
    getAccessible().addAccessibleControlListener(new AccessibleControlAdapter() {
      @Override
      public void getRole(AccessibleControlEvent e) {
        e.detail = ACC.ROLE_LIST;
      }
    });
    getAccessible().addAccessibleListener(new AccessibleAdapter() {
      @Override
      public void getName(AccessibleEvent e) {
        e.result = pointed().map(RowList.this::spoken).orElse("");
      }
    });
  }
}
