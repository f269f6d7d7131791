package org.robotui.uic.joints.internal.view;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.uic.joints.internal.model.JointRow;

/** Paints where a joint is between the ends of its range. Display thread. */
final class RangePainter {
  private static final int THICKNESS = 4;
  private static final int TICK = 10;
  private static final int KNOB = 9;
  private static final int FIGURES = 66;
  private static final int ROOM_FOR_FIGURES = 240;
  private static final int LEAST = 30;

  private final Theme theme;
  private final boolean degrees;

  RangePainter(Theme theme, boolean degrees) {
    this.theme = theme;
    this.degrees = degrees;
  }

  void paint(GC gc, Rectangle at, JointRow row) {
    if (!row.span().isKnown() || at.width < LEAST) {
      return;
    }
    boolean figures = at.width >= ROOM_FOR_FIGURES;
    int aside = figures ? FIGURES : KNOB / 2;
    if (figures) {
      figure(gc, at, at.x, row.unit().position(row.span().min(), degrees), true);
      figure(gc, at, at.x + at.width - FIGURES, row.unit().position(row.span().max(), degrees), false);
    }
    bar(gc, new Rectangle(at.x + aside, at.y + at.height / 2, at.width - 2 * aside, 0), row);
  }

  private void bar(GC gc, Rectangle line, JointRow row) {
    gc.setAntialias(SWT.ON);
    gc.setBackground(theme.dark() ? theme.color(Role.GROUND) : theme.color(Role.LINE));
    gc.fillRoundRectangle(line.x, line.y - THICKNESS / 2, line.width, THICKNESS, THICKNESS, THICKNESS);
    gc.setBackground(row.span().configured() ? theme.color(Role.DIM) : theme.mix(Role.DIM, Role.PANEL, 0.5));
    gc.fillRectangle(line.x, line.y - TICK / 2, 2, TICK);
    gc.fillRectangle(line.x + line.width - 2, line.y - TICK / 2, 2, TICK);
    if (!Double.isNaN(row.share())) {
      gc.setBackground(theme.color(knob(row)));
      int x = line.x + (int) Math.round((line.width - KNOB) * row.share());
      gc.fillOval(x, line.y - KNOB / 2, KNOB, KNOB);
    }
  }

  private static Role knob(JointRow row) {
    return row.stale() ? Role.DIM : row.span().isBeyond(row.joint().position()) ? Role.WARNING : Role.ACCENT;
  }

  private void figure(GC gc, Rectangle at, int x, String text, boolean right) {
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    gc.setForeground(theme.color(Role.DIM));
    Point size = gc.textExtent(text);
    int left = right ? x + FIGURES - Theme.STEP - size.x - KNOB / 2 : x + Theme.STEP + KNOB / 2;
    gc.drawText(text, left, at.y + (at.height - size.y) / 2, true);
  }
}
