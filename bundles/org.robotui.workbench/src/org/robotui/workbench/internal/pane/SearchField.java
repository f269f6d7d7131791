package org.robotui.workbench.internal.pane;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/** Opens the search for commands and views; looks like the field that then opens. Display thread only. */
final class SearchField extends Canvas {
  private static final String WORDS = "Search commands, views\u2026";
  private static final int CORNER = 10;

  private final Theme theme;
  private String keys = "";

  SearchField(Composite parent, Theme theme, Runnable open) {
    super(parent, SWT.DOUBLE_BUFFERED);
    this.theme = theme;
    setBackground(parent.getBackground());
    keys("");
    addPaintListener(e -> paint(e.gc));
    addListener(SWT.MouseDown, e -> open.run());
    addListener(SWT.FocusIn, e -> redraw());
    addListener(SWT.FocusOut, e -> redraw());
    addListener(SWT.KeyDown, e -> {
      if (e.character == ' ' || e.character == SWT.CR) {
        open.run();
      }
    });
    addListener(SWT.Traverse, e -> e.doit = e.detail != SWT.TRAVERSE_RETURN);
  }

  /** Which keys do the same, empty for none. */
  void keys(String now) {
    if (!keys.equals(now) || getToolTipText() == null) {
      keys = now;
      setToolTipText("Search commands, views, topics and settings" + (now.isEmpty() ? "" : " (" + now + ")"));
      redraw();
    }
  }

  private void paint(GC gc) {
    Point size = getSize();
    gc.setAntialias(SWT.ON);
    gc.setBackground(theme.mix(Role.PANEL, Role.GROUND, 0.5));
    gc.fillRoundRectangle(0, 0, size.x - 1, size.y - 1, CORNER, CORNER);
    gc.setForeground(theme.color(isFocusControl() ? Role.ACCENT : Role.LINE));
    gc.drawRoundRectangle(0, 0, size.x - 1, size.y - 1, CORNER, CORNER);
    gc.setForeground(theme.color(Role.DIM));
    gc.setFont(theme.font(Face.SMALL));
    Point room = gc.textExtent(keys);
    gc.drawText(keys, size.x - room.x - Theme.EDGE, (size.y - room.y) / 2, true);
    gc.setFont(theme.font(Face.BODY));
    String fitting = TextFit.shorten(gc, WORDS, size.x - room.x - 3 * Theme.EDGE);
    gc.drawText(fitting, Theme.EDGE, (size.y - gc.textExtent(fitting).y) / 2, true);
  }
}
