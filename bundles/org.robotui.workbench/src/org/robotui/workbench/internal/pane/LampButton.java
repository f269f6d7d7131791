package org.robotui.workbench.internal.pane;

import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.accessibility.AccessibleAdapter;
import org.eclipse.swt.accessibility.AccessibleEvent;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/** A mark and a few words in the bar at the top, which are pressed as a button is. Display thread only. */
abstract class LampButton extends Canvas {
  private static final int CORNER = 10;

  private final Theme theme;
  private boolean hot;

  LampButton(Composite parent, Theme theme, Consumer<Control> pressed) {
    super(parent, SWT.DOUBLE_BUFFERED);
    this.theme = theme;
    setBackground(parent.getBackground());
    addPaintListener(e -> paint(e.gc));
    addListener(SWT.MouseEnter, e -> hot(true));
    addListener(SWT.MouseExit, e -> hot(false));
    addListener(SWT.MouseDown, e -> pressed.accept(this));
    addListener(SWT.FocusIn, e -> redraw());
    addListener(SWT.FocusOut, e -> redraw());
    addListener(SWT.KeyDown, e -> {
      if (e.character == ' ' || e.character == SWT.CR) {
        pressed.accept(this);
      }
    });
    addListener(SWT.Traverse, e -> e.doit = e.detail != SWT.TRAVERSE_RETURN);
    getAccessible().addAccessibleListener(new AccessibleAdapter() {
      @Override
      public void getName(AccessibleEvent e) {
        e.result = spoken();
      }
    });
  }

  /** What it is called by screen readers. */
  abstract String spoken();

  /** Its edge while it has not the focus. */
  abstract Role edge();

  /** Its words, and how they look. */
  abstract Label label();

  /** Paints the mark at a height; answers where the words begin. */
  abstract int mark(GC gc, Theme colours, int middle);

  /** Words, and how they look. */
  record Label(String words, Face face, Role role) {}

  private void hot(boolean now) {
    hot = now;
    redraw();
  }

  private void paint(GC gc) {
    Point size = getSize();
    gc.setAntialias(SWT.ON);
    gc.setBackground(theme.mix(Role.TEXT, Role.GROUND, hot ? 0.08 : 0.0));
    gc.fillRoundRectangle(0, 0, size.x - 1, size.y - 1, CORNER, CORNER);
    gc.setForeground(theme.color(isFocusControl() ? Role.ACCENT : edge()));
    gc.setLineWidth(1);
    gc.drawRoundRectangle(0, 0, size.x - 1, size.y - 1, CORNER, CORNER);
    int left = mark(gc, theme, size.y / 2);
    Label label = label();
    gc.setFont(theme.font(label.face()));
    gc.setForeground(theme.color(label.role()));
    String words = TextFit.shorten(gc, label.words(), size.x - left - Theme.STEP);
    gc.drawText(words, left, (size.y - gc.textExtent(words).y) / 2, true);
  }
}
