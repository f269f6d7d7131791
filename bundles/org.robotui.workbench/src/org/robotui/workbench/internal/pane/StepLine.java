package org.robotui.workbench.internal.pane;

import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** The steps of a form, and which of them is shown. Display thread only. */
final class StepLine {
  private static final int HEIGHT = 44;
  private static final int CIRCLE = 22;
  private static final int GAP = 28;

  private final Theme theme;
  private final List<String> steps;
  private final PaintedCanvas canvas;
  private int shown;

  StepLine(Composite parent, Theme theme, List<String> steps) {
    this.theme = theme;
    this.steps = steps;
    canvas = new PaintedCanvas(parent, SWT.NO_FOCUS, theme, Role.TITLE, this::paint);
    GridData data = new GridData(SWT.FILL, SWT.TOP, true, false);
    data.heightHint = HEIGHT;
    canvas.setLayoutData(data);
  }

  void show(int step) {
    shown = step;
    canvas.redraw();
  }

  private void paint(GC gc, Rectangle area) {
    gc.setAntialias(SWT.ON);
    int left = Theme.EDGE;
    for (int i = 0; i < steps.size(); i++) {
      int top = (area.height - CIRCLE) / 2;
      boolean reached = i <= shown;
      gc.setBackground(reached ? theme.color(Role.ACCENT) : theme.mix(Role.DIM, Role.TITLE, 0.3));
      gc.fillOval(left, top, CIRCLE, CIRCLE);
      gc.setFont(theme.font(Face.SMALL_STRONG));
      gc.setForeground(reached ? theme.on(Role.ACCENT) : theme.color(Role.TEXT));
      middle(gc, Integer.toString(i + 1), left + CIRCLE / 2, area.height / 2);
      left += CIRCLE + 2 * Theme.STEP;
      gc.setFont(theme.font(i == shown ? Face.TITLE : Face.NAME));
      gc.setForeground(theme.color(i == shown ? Role.TEXT : Role.DIM));
      Point size = gc.textExtent(steps.get(i));
      gc.drawText(steps.get(i), left, (area.height - size.y) / 2, true);
      left += size.x + GAP;
    }
  }

  private static void middle(GC gc, String text, int x, int y) {
    Point size = gc.textExtent(text);
    gc.drawText(text, x - size.x / 2, y - size.y / 2, true);
  }
}
