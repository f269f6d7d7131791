package org.robotui.ui.control;

import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/** The line below a form that sums up what is wrong; a click leads there. Display thread. */
final class FormSummary {
  private static final int HEIGHT = 26;

  private final PaintedCanvas canvas;
  private final Theme theme;
  private String words = "";

  FormSummary(Composite parent, Theme theme, Runnable clicked) {
    this.theme = theme;
    canvas = new PaintedCanvas(parent, SWT.NO_FOCUS, theme, Role.PANEL, this::paint);
    GridData data = new GridData(SWT.FILL, SWT.BOTTOM, true, false);
    data.heightHint = HEIGHT;
    data.exclude = true;
    canvas.setLayoutData(data);
    canvas.setVisible(false);
    canvas.setCursor(canvas.getDisplay().getSystemCursor(SWT.CURSOR_HAND));
    canvas.addListener(SWT.MouseUp, e -> clicked.run());
    Spoken.name(canvas, "What is wrong");
  }

  void show(List<FormProblem> problems) {
    words = problems.isEmpty() ? "" : words(problems);
    GridData data = (GridData) canvas.getLayoutData();
    if (data.exclude != problems.isEmpty()) {
      data.exclude = problems.isEmpty();
      canvas.setVisible(!problems.isEmpty());
      canvas.getParent().layout(true);
    }
    canvas.setToolTipText(words.replace("&", "&&"));
    canvas.redraw();
  }

  private static String words(List<FormProblem> problems) {
    FormProblem first = problems.getFirst();
    String more = problems.size() == 1 ? "" : ", and " + (problems.size() - 1) + " more";
    return first.path() + ' ' + first.sentence() + more;
  }

  private void paint(GC gc, Rectangle area) {
    gc.setForeground(theme.color(Role.LINE));
    gc.drawLine(0, 0, area.width, 0);
    HealthDot.paint(gc, theme, Health.BAD, Theme.EDGE + HealthDot.SIZE / 2, area.height / 2);
    gc.setFont(theme.font(Face.BODY));
    gc.setForeground(theme.color(Role.TEXT));
    int left = Theme.EDGE + HealthDot.SIZE + 2 * Theme.STEP;
    String shown = TextFit.shorten(gc, words, area.width - left - Theme.EDGE);
    Point size = gc.textExtent(shown);
    gc.drawText(shown, left, (area.height - size.y) / 2, true);
  }
}
