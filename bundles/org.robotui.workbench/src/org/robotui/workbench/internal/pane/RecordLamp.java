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
import org.robotui.workbench.internal.model.RecordWords;

/** Whether it records, for how long and how much; a press opens its menu. Display thread only. */
final class RecordLamp extends Canvas {
  private static final int CORNER = 10;
  private static final int DOT = 10;

  private final Theme theme;
  private RecordWords words = RecordWords.IDLE;
  private boolean hot;

  RecordLamp(Composite parent, Theme theme, Consumer<Control> pressed) {
    super(parent, SWT.DOUBLE_BUFFERED);
    this.theme = theme;
    setBackground(parent.getBackground());
    setToolTipText(words.hint());
    addPaintListener(e -> paint(e.gc));
    addListener(SWT.MouseEnter, e -> hot(true));
    addListener(SWT.MouseExit, e -> hot(false));
    addListener(SWT.MouseDown, e -> pressed.accept(this));
    addListener(SWT.FocusIn, e -> redraw());
    addListener(SWT.FocusOut, e -> redraw());
    addListener(SWT.KeyDown, e -> {
      if (e.character == ' ' || e.character == SWT.CR || e.keyCode == SWT.ARROW_DOWN) {
        pressed.accept(this);
      }
    });
    addListener(SWT.Traverse, e -> e.doit = e.detail != SWT.TRAVERSE_RETURN);
    getAccessible().addAccessibleListener(new AccessibleAdapter() {
      @Override
      public void getName(AccessibleEvent e) {
        e.result = words.on() ? "Recording, " + words.text() : words.text();
      }
    });
  }

  void show(RecordWords shown) {
    if (!words.equals(shown)) {
      words = shown;
      setToolTipText(shown.hint());
      redraw();
    }
  }

  private void hot(boolean now) {
    hot = now;
    redraw();
  }

  /** The stop alone is filled with red: this is a red dot and red words. */
  private void paint(GC gc) {
    Point size = getSize();
    gc.setAntialias(SWT.ON);
    gc.setBackground(theme.mix(Role.TEXT, Role.GROUND, hot ? 0.08 : 0.0));
    gc.fillRoundRectangle(0, 0, size.x - 1, size.y - 1, CORNER, CORNER);
    gc.setForeground(theme.color(isFocusControl() ? Role.ACCENT : words.on() ? Role.BAD : Role.LINE));
    gc.setLineWidth(1);
    gc.drawRoundRectangle(0, 0, size.x - 1, size.y - 1, CORNER, CORNER);
    int left = 2 * Theme.STEP;
    gc.setBackground(theme.color(words.on() ? Role.BAD : Role.DIM));
    gc.fillOval(left, (size.y - DOT) / 2, DOT, DOT);
    gc.setFont(theme.font(words.on() ? Face.BODY_STRONG : Face.BODY));
    gc.setForeground(theme.color(words.on() ? Role.BAD : Role.TEXT));
    left += DOT + 2 * Theme.STEP;
    String text = TextFit.shorten(gc, words.text(), size.x - left - Theme.STEP);
    gc.drawText(text, left, (size.y - gc.textExtent(text).y) / 2, true);
  }
}
