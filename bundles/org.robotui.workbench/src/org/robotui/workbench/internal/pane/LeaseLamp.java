package org.robotui.workbench.internal.pane;

import org.eclipse.swt.SWT;
import org.eclipse.swt.accessibility.AccessibleAdapter;
import org.eclipse.swt.accessibility.AccessibleEvent;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.model.Lease;

/** Who drives; a press takes control or releases it. Display thread only. */
final class LeaseLamp extends Canvas {
  private static final int CORNER = 10;

  private final Theme theme;
  private Lease lease = new Lease(Health.NONE, "Nothing to drive");
  private boolean hot;

  LeaseLamp(Composite parent, Theme theme, Runnable pressed) {
    super(parent, SWT.DOUBLE_BUFFERED);
    this.theme = theme;
    setBackground(parent.getBackground());
    addPaintListener(e -> paint(e.gc));
    addListener(SWT.MouseEnter, e -> hot(true));
    addListener(SWT.MouseExit, e -> hot(false));
    addListener(SWT.MouseDown, e -> pressed.run());
    addListener(SWT.FocusIn, e -> redraw());
    addListener(SWT.FocusOut, e -> redraw());
    addListener(SWT.KeyDown, e -> {
      if (e.character == ' ' || e.character == SWT.CR) {
        pressed.run();
      }
    });
    addListener(SWT.Traverse, e -> e.doit = e.detail != SWT.TRAVERSE_RETURN);
    getAccessible().addAccessibleListener(new AccessibleAdapter() {
      @Override
      public void getName(AccessibleEvent e) {
        e.result = lease.words();
      }
    });
  }

  void show(Lease shown) {
    if (!lease.equals(shown)) {
      lease = shown;
      setToolTipText(shown.words() + "; press to take or release control");
      redraw();
    }
  }

  Lease shown() {
    return lease;
  }

  private void hot(boolean now) {
    hot = now;
    redraw();
  }

  private void paint(GC gc) {
    Point size = getSize();
    gc.setAntialias(SWT.ON);
    gc.setBackground(theme.mix(Role.TEXT, Role.GROUND, hot ? 0.08 : 0.0));
    gc.fillRoundRectangle(0, 0, size.x - 1, size.y - 1, CORNER, CORNER);
    gc.setForeground(theme.color(isFocusControl() ? Role.ACCENT : Role.LINE));
    gc.setLineWidth(1);
    gc.drawRoundRectangle(0, 0, size.x - 1, size.y - 1, CORNER, CORNER);
    HealthDot.paint(gc, theme, lease.health(), Theme.EDGE + HealthDot.SIZE / 2, size.y / 2);
    gc.setFont(theme.font(Face.BODY));
    gc.setForeground(theme.color(lease.health() == Health.BAD ? Role.BAD : Role.TEXT));
    int left = Theme.EDGE + HealthDot.SIZE + 2 * Theme.STEP;
    String words = TextFit.shorten(gc, lease.words(), size.x - left - Theme.STEP);
    gc.drawText(words, left, (size.y - gc.textExtent(words).y) / 2, true);
  }
}
