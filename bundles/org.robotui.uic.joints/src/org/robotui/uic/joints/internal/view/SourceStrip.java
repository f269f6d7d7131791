package org.robotui.uic.joints.internal.view;

import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.HealthDot;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.uic.joints.internal.model.JointsLook;
import org.robotui.uic.joints.internal.model.SourceRow;

/** The sources in a line, each with its rate and age, as many as there is room for. Display thread. */
final class SourceStrip {
  private static final int LEAST = 120;
  private static final int LEAST_FIRST = 60;
  private static final int GAP = 20;

  private final Theme theme;
  private final PaintedCanvas canvas;
  private List<SourceRow> sources = List.of();

  SourceStrip(Composite parent, Theme theme) {
    this.theme = theme;
    this.canvas = new PaintedCanvas(parent, SWT.NO_FOCUS, theme, Role.PANEL, this::paint);
  }

  Control control() {
    return canvas;
  }

  void show(List<SourceRow> next) {
    if (!next.equals(sources)) {
      sources = next;
      StringBuilder all = new StringBuilder();
      next.forEach(source -> all.append(all.isEmpty() ? "" : "\n").append(source.source()).append(": ")
          .append(JointsLook.words(source)));
      canvas.setToolTipText(all.toString().replace("&", "&&"));
      canvas.redraw();
    }
  }

  private void paint(GC gc, Rectangle area) {
    int x = area.x + Theme.STEP;
    int end = area.x + area.width;
    for (int i = 0; i < sources.size(); i++) {
      if (end - x < (i == 0 ? LEAST_FIRST : LEAST)) {
        text(gc, area, x, end - x, i == 0 ? "" : "+" + (sources.size() - i), Face.BODY, Role.DIM);
        return;
      }
      x = source(gc, area, x, end, sources.get(i)) + GAP;
    }
  }

  private int source(GC gc, Rectangle area, int left, int end, SourceRow source) {
    HealthDot.paint(gc, theme, StateView.health(source.state()), left + HealthDot.SIZE / 2, area.y + area.height / 2);
    int x = left + HealthDot.SIZE + 2 * Theme.STEP;
    x += text(gc, area, x, end - x, source.source().toString(), Face.BODY, Role.TEXT) + 2 * Theme.STEP;
    return x + text(gc, area, x, end - x, JointsLook.words(source), Face.FIGURES, Role.DIM);
  }

  private int text(GC gc, Rectangle area, int x, int width, String words, Face face, Role role) {
    gc.setFont(theme.font(face));
    String text = TextFit.shorten(gc, words, width);
    Point size = gc.textExtent(text);
    gc.setForeground(theme.color(role));
    gc.drawText(text, x, area.y + (area.height - size.y) / 2, true);
    return size.x;
  }
}
