package org.robotui.uic.jointcontrol.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.data.joint.JointControl.Source;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.uic.jointcontrol.internal.model.Aim;
import org.robotui.uic.jointcontrol.internal.model.JointRow;

/**
 * A joint between its limits: a bar to where it is measured, a mark where it is commanded, and a knob where the user
 * drives it. Display thread.
 */
final class RangeBar {
  private static final int ASIDE = 16;
  private static final int THICKNESS = 8;
  private static final int TICK = 14;
  private static final int KNOB = 13;
  private static final int MARK = 4;
  private static final double FILLED = 0.55;

  private final Theme theme;

  RangeBar(Theme theme) {
    this.theme = theme;
  }

  /** The share of the span that lies under the pointer. */
  static double share(int left, int width, int x) {
    return (double) (x - left - ASIDE) / Math.max(1, width - 2 * ASIDE);
  }

  /** Where a share of the span lies. */
  static int x(int left, int width, double share) {
    return left + ASIDE + (int) Math.round((width - 2 * ASIDE) * share);
  }

  void paint(GC gc, Rectangle cell, JointRow row, boolean drivable) {
    Rectangle track =
        new Rectangle(cell.x + ASIDE, cell.y + (cell.height - THICKNESS) / 2, cell.width - 2 * ASIDE, THICKNESS);
    gc.setAntialias(SWT.ON);
    track(gc, track, row);
    measured(gc, track, row);
    commanded(gc, track, row);
    if (drivable) {
      knob(gc, track, row);
    }
  }

  private void track(GC gc, Rectangle track, JointRow row) {
    gc.setBackground(theme.dark() ? theme.color(Role.GROUND) : theme.mix(Role.LINE, Role.PANEL, 0.8));
    gc.fillRoundRectangle(track.x, track.y, track.width, THICKNESS, THICKNESS / 2, THICKNESS / 2);
    if (row.span().limited()) {
      gc.setBackground(theme.mix(Role.DIM, Role.PANEL, 0.8));
      int top = track.y - (TICK - THICKNESS) / 2;
      gc.fillRectangle(track.x - 2, top, 2, TICK);
      gc.fillRectangle(track.x + track.width, top, 2, TICK);
    }
  }

  private void measured(GC gc, Rectangle track, JointRow row) {
    double share = row.span().share(row.state().measured().position());
    if (Double.isNaN(share)) {
      return;
    }
    Role role = role(row);
    int from = x(track, row.span().origin());
    int to = x(track, share);
    gc.setBackground(theme.mix(role, Role.PANEL, FILLED));
    gc.fillRectangle(Math.min(from, to), track.y, Math.abs(to - from), THICKNESS);
    gc.setBackground(theme.color(role));
    gc.fillRectangle(to - 1, track.y - 2, 3, THICKNESS + 4);
  }

  private static Role role(JointRow row) {
    if (row.span().isAtLimit(row.state().measured().position())) {
      return Role.WARNING;
    }
    return row.state().source() == Source.FREE ? Role.DIM : Role.ACCENT;
  }

  /** A mark above and below the bar, which no bar covers. */
  private void commanded(GC gc, Rectangle track, JointRow row) {
    if (!row.hasReference()) {
      return;
    }
    int x = x(track, row.span().share(row.state().reference().position()));
    gc.setBackground(theme.color(Role.TEXT));
    int top = track.y - 1;
    int bottom = track.y + THICKNESS + 1;
    gc.fillPolygon(new int[]{x - MARK, top - MARK, x + MARK + 1, top - MARK, x, top + 1});
    gc.fillPolygon(new int[]{x - MARK, bottom + MARK, x + MARK + 1, bottom + MARK, x, bottom - 1});
  }

  private void knob(GC gc, Rectangle track, JointRow row) {
    Optional<Aim> aim = row.aim();
    double position = aim.map(Aim::goal).orElse(row.state().measured().position());
    if (Double.isNaN(position)) {
      return;
    }
    int middle = track.y + THICKNESS / 2;
    aim.filter(Aim::isMoving)
        .ifPresent(a -> way(gc, x(track, row.span().share(a.target())), x(track, row.span().share(a.goal())), middle));
    int x = x(track, row.span().share(position));
    circle(gc, x, middle, KNOB, theme.color(Role.PANEL));
    circle(gc, x, middle, KNOB - 2, theme.color(Role.ACCENT));
    if (aim.isEmpty()) {
      circle(gc, x, middle, KNOB - 6, theme.color(Role.PANEL));
    }
  }

  /** What is still to be gone. */
  private void way(GC gc, int from, int to, int middle) {
    gc.setForeground(theme.color(Role.ACCENT));
    gc.setLineWidth(2);
    gc.drawLine(from, middle, to, middle);
  }

  private static void circle(GC gc, int x, int y, int size, Color color) {
    gc.setBackground(color);
    gc.fillOval(x - size / 2, y - size / 2, size, size);
  }

  private static int x(Rectangle track, double share) {
    return track.x + (int) Math.round(track.width * share);
  }
}
