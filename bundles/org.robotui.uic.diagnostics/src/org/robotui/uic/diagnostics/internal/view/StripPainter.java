package org.robotui.uic.diagnostics.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.uic.diagnostics.internal.model.Level;
import org.robotui.uic.diagnostics.internal.model.Strip;

/** Paints how something was: the worse, the higher; what did not report is hollow. Display thread. */
final class StripPainter {
  private static final double GROUND = 0.5;

  /** What was is quieter than what is. */
  private static final double INK = 0.7;

  private final Theme theme;

  StripPainter(Theme theme) {
    this.theme = theme;
  }

  void paint(GC gc, Rectangle at, Strip strip, Optional<Long> cursor) {
    gc.setAntialias(SWT.OFF);
    gc.setLineWidth(1);
    gc.setForeground(theme.mix(Role.LINE, Role.PANEL, GROUND));
    gc.drawLine(at.x, at.y + at.height - 1, at.x + at.width - 1, at.y + at.height - 1);
    int start = 0;
    for (int x = 1; x <= at.width; x++) {
      if (x == at.width || level(strip, at.width, x) != level(strip, at.width, start)) {
        run(gc, at, start, x, level(strip, at.width, start));
        start = x;
      }
    }
    cursor.filter(slot -> strip.index(slot) >= 0).ifPresent(slot -> cursor(gc, at, strip, slot));
    gc.setAntialias(SWT.ON);
  }

  /** The slot at a place of a strip. */
  static long slot(Strip strip, int x, int width) {
    return strip.slot(Math.clamp((long) x * strip.size() / Math.max(1, width), 0, strip.size() - 1));
  }

  /** The worst of all slots that fall on a column of pixels. */
  static Level level(Strip strip, int width, int x) {
    int from = (int) ((long) x * strip.size() / width);
    int to = Math.max(from + 1, (int) ((x + 1L) * strip.size() / width));
    Level worst = Level.UNKNOWN;
    for (int i = from; i < Math.min(to, strip.size()); i++) {
      worst = worst.worse(strip.level(i));
    }
    return worst;
  }

  private void run(GC gc, Rectangle at, int from, int to, Level level) {
    int height = (int) Math.round(at.height * Levels.height(level));
    if (height == 0) {
      return;
    }
    int top = at.y + at.height - height;
    if (level == Level.STALE) {
      gc.setForeground(theme.color(Role.DIM));
      gc.drawRectangle(at.x + from, top, Math.max(1, to - from - 1), height - 1);
    } else {
      gc.setBackground(theme.mix(Levels.role(level), Role.PANEL, INK));
      gc.fillRectangle(at.x + from, top, to - from, height);
    }
  }

  private void cursor(GC gc, Rectangle at, Strip strip, long slot) {
    int x = at.x + (int) ((strip.index(slot) + 0.5) * at.width / strip.size());
    gc.setForeground(theme.color(Role.ACCENT));
    gc.setLineWidth(2);
    gc.drawLine(x, at.y - 2, x, at.y + at.height + 1);
    gc.setLineWidth(1);
  }
}
