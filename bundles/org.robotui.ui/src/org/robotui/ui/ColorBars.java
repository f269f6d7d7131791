package org.robotui.ui;

import java.util.List;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;

/** Paints what colours mean at the right edge of a view, one bar beside the other. Display thread. */
public final class ColorBars {
  private static final int TALLEST = 160;
  private static final int LEAST_AREA = 230;
  private static final int TITLE = 18;
  private static final int LONGEST = 220;

  private final Theme theme;
  private final StateView states;

  /**
   * For a view.
   *
   * @param theme its colours and fonts
   */
  public ColorBars(Theme theme) {
    this.theme = theme;
    this.states = new StateView(theme);
  }

  /**
   * Paints those for which there is room.
   *
   * @param gc where
   * @param area the view
   * @param bars the first at the right
   */
  public void paint(GC gc, Rectangle area, List<ColorBar> bars) {
    if (Math.min(area.width, area.height) < LEAST_AREA) {
      return;
    }
    int right = area.x + area.width - Theme.EDGE;
    int height = Math.min(TALLEST, area.height / 2);
    for (ColorBar bar : bars) {
      int width = width(gc, bar);
      if (right - width < area.x + area.width / 2) {
        return;
      }
      paint(gc, new Rectangle(right - width, area.y + (area.height - height - TITLE) / 2, width, height + TITLE), bar);
      right -= width + Theme.EDGE;
    }
  }

  private int width(GC gc, ColorBar bar) {
    gc.setFont(theme.font(Face.SMALL));
    int title = Math.min(LONGEST, gc.textExtent(bar.title()).x);
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    return Math.max(title, bar.width(gc)) + 4 * Theme.STEP;
  }

  private void paint(GC gc, Rectangle place, ColorBar bar) {
    states.pill(gc, place);
    gc.setFont(theme.font(Face.SMALL));
    gc.setForeground(theme.color(Role.TEXT));
    String title = TextFit.shortenFront(gc, bar.title(), place.width - 4 * Theme.STEP);
    Point size = gc.textExtent(title);
    gc.drawText(title, place.x + place.width - 2 * Theme.STEP - size.x, place.y + Theme.STEP, true);
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    bar.paint(gc, theme, place.x + place.width - 2 * Theme.STEP, place.y + TITLE + Theme.STEP,
        place.height - TITLE - 3 * Theme.STEP);
  }
}
