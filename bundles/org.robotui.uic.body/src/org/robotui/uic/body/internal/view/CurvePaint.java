package org.robotui.uic.body.internal.view;

import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.uic.body.internal.model.BodyPast;

/** Paints what a line says, and its numbers over time. Display thread. */
final class CurvePaint {
  private static final int HEIGHT = 128;
  private static final int LINE = 20;
  private static final int TOP = 6;
  /** How high it is where there are no numbers: three lines. */
  static final int WORDS = 3 * LINE + 2 * TOP;

  private static final double LEAST_SPAN = 1;

  private final Theme theme;

  CurvePaint(Theme theme) {
    this.theme = theme;
  }

  static int height(BodyPast past) {
    return hasCurve(past) ? HEIGHT : WORDS;
  }

  private static boolean hasCurve(BodyPast past) {
    return past.curve().size() > 1;
  }

  void paint(GC gc, Rectangle area, BodyPast past) {
    int left = area.x + Theme.EDGE;
    int width = area.width - 2 * Theme.EDGE;
    text(gc, left, area.y + TOP, width, past.line().title(), Face.BODY_STRONG, Role.TEXT);
    text(gc, left, area.y + TOP + LINE, width, past.line().value(), Face.BODY, Role.TEXT);
    if (!hasCurve(past) || width <= 0) {
      text(gc, left, area.y + TOP + 2 * LINE, width, "came " + Figures.ageOfValue(past.line().age()) + " ago",
          Face.SMALL, Role.DIM);
      return;
    }
    curve(gc, new Rectangle(left, area.y + TOP + 2 * LINE + Theme.STEP, width, HEIGHT - 3 * LINE - TOP - Theme.STEP),
        past);
  }

  private void curve(GC gc, Rectangle at, BodyPast past) {
    List<BodyPast.Point> points = past.curve();
    double least = past.least().orElse(0);
    double most = past.most().orElse(0);
    double span = Math.max(LEAST_SPAN, points.getFirst().ago());
    double height = most > least ? most - least : 1;
    int[] line = new int[points.size() * 2];
    for (int i = 0; i < points.size(); i++) {
      line[2 * i] = at.x + (int) Math.round((1 - points.get(i).ago() / span) * at.width);
      line[2 * i + 1] = at.y + at.height - 1
          - (int) Math.round((points.get(i).value() - least) / height * (at.height - 2));
    }
    gc.setForeground(theme.mix(Role.LINE, Role.PANEL, 0.6));
    gc.drawLine(at.x, at.y + at.height, at.x + at.width, at.y + at.height);
    gc.setAntialias(SWT.ON);
    gc.setForeground(theme.color(Role.ACCENT));
    gc.setLineWidth(2);
    gc.drawPolyline(line);
    gc.setLineWidth(1);
    String range = number(least) + " to " + number(most) + " in " + Figures.age(span);
    text(gc, at.x, at.y + at.height + 2, at.width, range, Face.SMALL, Role.DIM);
  }

  private static String number(double value) {
    return Figures.fixed(value, Math.abs(value) < 10 ? 3 : 1);
  }

  private void text(GC gc, int x, int y, int width, String text, Face face, Role role) {
    gc.setFont(theme.font(face));
    gc.setForeground(theme.color(role));
    gc.drawText(TextFit.shorten(gc, text, Math.max(0, width)), x, y, true);
  }
}
