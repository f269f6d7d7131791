package org.robotui.uic.plugins.internal.view;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.uic.plugins.internal.model.Line;

/**
 * How much of its period something takes: p50 strong, p99 fainter, the longest as a mark, and that in figures. Display
 * thread.
 */
final class BudgetBar {
  private static final int THICKNESS = 8;
  private static final int TICK = 14;
  private static final int FIGURES = 50;
  private static final double FAINT = 0.4;
  private static final double MUCH = 0.8;
  private static final double PERCENT = 100;

  private final Theme theme;

  BudgetBar(Theme theme) {
    this.theme = theme;
  }

  void paint(GC gc, Rectangle at, Line line) {
    if (line.period() <= 0 || line.busy().isEmpty()) {
      return;
    }
    double share = line.busy().share(line.period());
    Role role = share >= 1 ? Role.BAD : share >= MUCH ? Role.WARNING : Role.ACCENT;
    Rectangle track = new Rectangle(at.x, at.y + (at.height - THICKNESS) / 2, at.width - FIGURES, THICKNESS);
    gc.setAntialias(SWT.ON);
    gc.setBackground(theme.dark() ? theme.color(Role.GROUND) : theme.mix(Role.LINE, Role.PANEL, 0.8));
    gc.fillRoundRectangle(track.x, track.y, track.width, THICKNESS, THICKNESS / 2, THICKNESS / 2);
    gc.setAntialias(SWT.OFF);
    gc.setBackground(theme.mix(role, Role.PANEL, FAINT));
    gc.fillRectangle(track.x, track.y, width(track, line.busy().p99() / line.period()), THICKNESS);
    gc.setBackground(theme.color(role));
    gc.fillRectangle(track.x, track.y, width(track, line.busy().p50() / line.period()), THICKNESS);
    gc.fillRectangle(track.x + Math.max(0, width(track, share) - 2), track.y - (TICK - THICKNESS) / 2, 2, TICK);
    figure(gc, at, share, role);
  }

  private static int width(Rectangle track, double share) {
    return (int) Math.max(1, Math.round(track.width * Math.min(1, share)));
  }

  private void figure(GC gc, Rectangle at, double share, Role role) {
    String text = Figures.of(share * PERCENT, share * PERCENT < 10 ? 1 : 0, "%");
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    gc.setForeground(theme.color(role == Role.ACCENT ? Role.DIM : role));
    Point size = gc.textExtent(text);
    gc.drawText(text, at.x + at.width - size.x, at.y + (at.height - size.y) / 2, true);
  }
}
