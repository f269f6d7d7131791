package org.robotui.uic.camera.internal;

import java.util.Optional;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.entity.image.Legend;
import org.robotui.entity.image.Span;
import org.robotui.ui.ColorBar;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;

/**
 * What the colours mean: a bar at the right with its numbers, on which the wheel moves the nearer end. Display thread.
 */
final class LegendBar {
  private static final int TALLEST = 200;
  private static final int LEAST_AREA = 230;
  private static final int BAR = 12;
  private static final int ROW = 16;
  private static final double STEP = 0.05;

  private final Theme theme;
  private final StateView states;
  private Rectangle place = new Rectangle(0, 0, 0, 0);

  LegendBar(Theme theme) {
    this.theme = theme;
    this.states = new StateView(theme);
  }

  /** Paints where there is room. */
  void paint(GC gc, Rectangle area, Legend legend) {
    place = new Rectangle(0, 0, 0, 0);
    int height = Math.min(TALLEST, area.height / 2);
    if (Math.min(area.width, area.height) >= LEAST_AREA) {
      gc.setFont(theme.font(Face.SMALL_FIGURES));
      ColorBar bar = bar(legend);
      String nothing = nothing(legend);
      int words = legend.gaps() ? gc.textExtent(nothing).x + BAR + Theme.STEP : 0;
      int width = Math.max(bar.width(gc), words) + 4 * Theme.STEP;
      int left = area.x + area.width - Theme.EDGE - width;
      place = new Rectangle(left, area.y + (area.height - height) / 2, width,
          height + (legend.gaps() ? ROW + 3 * Theme.STEP : 3 * Theme.STEP));
      states.pill(gc, place);
      bar.paint(gc, theme, place.x + place.width - 2 * Theme.STEP, place.y + 2 * Theme.STEP, height - Theme.STEP);
      if (legend.gaps()) {
        nothing(gc, legend, nothing);
      }
    }
  }

  void hide() {
    place = new Rectangle(0, 0, 0, 0);
  }

  boolean contains(int x, int y) {
    return place.contains(x, y);
  }

  /** The range after a turn of the wheel there: the nearer end moves. */
  Optional<Span> turned(Legend legend, int y, int count) {
    Span span = legend.span();
    double step = (span.high() - span.low()) * STEP * Integer.signum(count);
    boolean upper = y < place.y + (place.height - (legend.gaps() ? ROW : 0)) / 2;
    double low = upper ? span.low() : span.low() + step;
    double high = upper ? span.high() + step : span.high();
    return low < high ? Optional.of(new Span(low, high)) : Optional.empty();
  }

  private void nothing(GC gc, Legend legend, String words) {
    int x = place.x + place.width - 2 * Theme.STEP - BAR;
    int y = place.y + place.height - Theme.STEP - ROW;
    gc.setBackground(color(legend.map().nothing()));
    gc.fillRectangle(x, y + 2, BAR, BAR);
    gc.setForeground(theme.color(Role.LINE));
    gc.drawRectangle(x, y + 2, BAR - 1, BAR - 1);
    gc.setForeground(theme.color(Role.DIM));
    Point size = gc.textExtent(words);
    gc.drawText(words, x - Theme.STEP - size.x, y + 2 + (BAR - size.y) / 2, true);
  }

  private static String nothing(Legend legend) {
    return legend.unit().isEmpty() ? "none" : "no depth";
  }

  private static ColorBar bar(Legend legend) {
    return new ColorBar("", legend.unit(), legend.span().low(), legend.span().high(),
        share -> legend.map().rgb(legend.reversed() ? 1 - share : share));
  }

  private static Color color(int rgb) {
    return new Color(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255);
  }
}
