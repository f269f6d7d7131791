package org.robotui.workbench.internal.timeline;

import java.util.Arrays;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** What the strip and the lanes paint alike. Display thread only. */
final class TimePaint {
  private static final int PAD = 4;

  private TimePaint() {}

  /** Messages as columns whose height is their share of the most; where there is one at all, it is seen. */
  static void density(GC gc, double[] columns, int left, int top, int height, Color color) {
    double most = Arrays.stream(columns).max().orElse(0);
    gc.setBackground(color);
    for (int x = 0; x < columns.length; x++) {
      if (columns[x] > 0) {
        int tall = (int) Math.max(2, Math.round(Math.sqrt(columns[x] / most) * height));
        gc.fillRectangle(left + x, top + height - tall, 1, tall);
      }
    }
  }

  /** A vertical line at a place, where it is within the time. */
  static void line(GC gc, TimeScale scale, int x, int top, int bottom, Color color, int width) {
    if (x >= scale.left() && x <= scale.left() + scale.width()) {
      gc.setForeground(color);
      gc.setLineWidth(width);
      gc.drawLine(x, top, x, bottom);
      gc.setLineWidth(1);
    }
  }

  /** Words at the pointer, on a ground of their own, within an area. */
  static void hint(GC gc, Theme theme, String words, int x, int y, Rectangle area) {
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    int width = gc.textExtent(words).x + 2 * PAD;
    int height = gc.textExtent(words).y;
    int left = Math.clamp(x + PAD, area.x, Math.max(area.x, area.x + area.width - width));
    gc.setBackground(theme.color(Role.TITLE));
    gc.fillRectangle(left, y, width, height);
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText(words, left + PAD, y, true);
  }
}
