package org.robotui.uic.camera.internal;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.entity.image.Legend;
import org.robotui.entity.image.Span;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
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
  private static final int TICKS = 4;
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
      String widest = label(legend, legend.span().high()).length() > label(legend, legend.span().low()).length()
          ? label(legend, legend.span().high())
          : label(legend, legend.span().low());
      String nothing = nothing(legend);
      int words = Math.max(gc.textExtent(widest).x, legend.gaps() ? gc.textExtent(nothing).x : 0);
      int width = words + BAR + 5 * Theme.STEP;
      int left = area.x + area.width - Theme.EDGE - width;
      place = new Rectangle(left, area.y + (area.height - height) / 2, width,
          height + (legend.gaps() ? ROW + 3 * Theme.STEP : 3 * Theme.STEP));
      states.pill(gc, place);
      bar(gc, legend, height);
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

  private void bar(GC gc, Legend legend, int height) {
    int x = place.x + place.width - 2 * Theme.STEP - BAR;
    int top = place.y + 2 * Theme.STEP;
    int length = height - Theme.STEP;
    int[] shades = legend.map().table(length, legend.reversed());
    gc.setAntialias(SWT.OFF);
    for (int i = 0; i < length; i++) {
      gc.setBackground(color(shades[length - 1 - i]));
      gc.fillRectangle(x, top + i, BAR, 1);
    }
    gc.setAntialias(SWT.ON);
    for (int i = 0; i <= TICKS; i++) {
      double value = legend.span().high() + (legend.span().low() - legend.span().high()) * i / TICKS;
      String text = label(legend, value);
      Point size = gc.textExtent(text);
      int y = top + i * (length - 1) / TICKS;
      int inside = Math.clamp((long) y - size.y / 2, top - 2, top + length - size.y + 2);
      gc.setForeground(theme.color(i == 0 || i == TICKS ? Role.TEXT : Role.DIM));
      gc.drawText(text, x - Theme.STEP - size.x, inside, true);
    }
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

  private static String label(Legend legend, double value) {
    double width = legend.span().high() - legend.span().low();
    int decimals = Math.clamp((long) Math.ceil(1.3 - Math.log10(width)), 0, 6);
    return Figures.of(value, decimals, legend.unit());
  }

  private static Color color(int rgb) {
    return new Color(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255);
  }
}
