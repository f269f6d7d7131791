package org.robotui.rfic.recording.internal.report;

import java.util.Locale;

/** A number over time: from the lowest to the highest of each column. */
final class SeriesFigure {
  private static final int WIDTH = 960;
  private static final int HEIGHT = 150;
  private static final int LEFT = 64;
  private static final int TOP = 8;
  private static final int BOTTOM = HEIGHT - 20;
  private static final double ROOM = 0.08;

  private final long origin;

  SeriesFigure(long origin) {
    this.origin = origin;
  }

  void draw(PageText page, BinnedSeries series) {
    page.markup("<figure><figcaption>").text(series.name() + ", " + series.unit())
        .element("small", " lowest " + number(series.lowest()) + ", mean " + number(series.mean()) + ", highest "
            + number(series.highest()))
        .markup("</figcaption>");
    page.format("<svg viewBox=\"0 0 %d %d\" role=\"img\" aria-label=\"", WIDTH, HEIGHT).text(series.name())
        .markup("\">");
    TimeAxis axis = new TimeAxis(series.bins().range(), origin, LEFT, WIDTH - LEFT - 20.0);
    axis.draw(page, TOP, BOTTOM);
    Scale scale = Scale.of(series);
    scale.draw(page);
    line(page, series, axis, scale);
    page.markup("</svg></figure>");
  }

  private static void line(PageText page, BinnedSeries series, TimeAxis axis, Scale scale) {
    page.markup("<path class=\"line\" d=\"");
    boolean begun = false;
    for (int bin = 0; bin < series.bins().count(); bin++) {
      if (series.has(bin)) {
        double x = axis.left() + axis.width() * (bin + 0.5) / series.bins().count();
        page.format("%s%.1f %.1fL%.1f %.1f", begun ? "L" : "M", x, scale.y(series.low(bin)), x,
            scale.y(series.high(bin)));
        begun = true;
      }
    }
    page.markup("\"/>");
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, Math.abs(value) >= 100 ? "%.0f" : "%.2f", value);
  }

  /** What lies at the top and at the bottom of the figure. */
  private record Scale(double low, double high) {
    static Scale of(BinnedSeries series) {
      double span = series.highest() - series.lowest();
      double room = span > 0 ? span * ROOM : Math.max(0.5, Math.abs(series.highest()) * ROOM);
      return new Scale(series.lowest() - room, series.highest() + room);
    }

    double y(double value) {
      return BOTTOM - (value - low) / (high - low) * (BOTTOM - TOP);
    }

    void draw(PageText page) {
      double step = step();
      for (double value = Math.ceil(low / step) * step; value <= high; value += step) {
        page.format("<line class=\"grid\" x1=\"%d\" y1=\"%.1f\" x2=\"%d\" y2=\"%.1f\"/>", LEFT, y(value), WIDTH - 20,
            y(value));
        page.format("<text class=\"value\" x=\"%d\" y=\"%.1f\">", LEFT - 6, y(value) + 4)
            .text(number(Math.abs(value) < step / 2 ? 0 : value)).markup("</text>");
      }
    }

    /** One, two or five times a power of ten, so that there are two to five lines. */
    private double step() {
      double least = (high - low) / 5;
      double power = Math.pow(10, Math.floor(Math.log10(least)));
      double part = least / power;
      return power * (part <= 1 ? 1 : part <= 2 ? 2 : part <= 5 ? 5 : 10);
    }
  }
}
