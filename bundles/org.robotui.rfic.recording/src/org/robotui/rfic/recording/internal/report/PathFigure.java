package org.robotui.rfic.recording.internal.report;

import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import org.robotui.geometry.Vector3;

/** Driven paths in one frame, seen from above: x to the right, y up, one metre alike in both. */
final class PathFigure {
  private static final int WIDTH = 960;
  private static final int LEAST_HEIGHT = 160;
  private static final int MOST_HEIGHT = 520;
  private static final int MARGIN = 24;
  private static final int COLOURS = 6;

  private final DoubleSummaryStatistics xs = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics ys = new DoubleSummaryStatistics();
  private final List<DrivenPath> paths;
  private final double scale;
  private final int height;

  PathFigure(List<DrivenPath> paths) {
    this.paths = paths;
    paths.forEach(path -> path.places().forEach(place -> {
      xs.accept(place.x());
      ys.accept(place.y());
    }));
    double wide = Math.max(1, xs.getMax() - xs.getMin());
    double high = Math.max(0.5, ys.getMax() - ys.getMin());
    scale = Math.min((WIDTH - 2.0 * MARGIN) / wide, (MOST_HEIGHT - 2.0 * MARGIN) / high);
    height = Math.clamp(Math.round(high * scale + 2 * MARGIN), LEAST_HEIGHT, MOST_HEIGHT);
  }

  void draw(PageText page) {
    page.format("<svg viewBox=\"0 0 %d %d\" role=\"img\" aria-label=\"Driven paths seen from above\">", WIDTH, height);
    for (int i = 0; i < paths.size(); i++) {
      draw(page, paths.get(i), i % COLOURS);
    }
    ruler(page);
    page.markup("</svg><ul class=\"legend\">");
    for (int i = 0; i < paths.size(); i++) {
      page.format("<li class=\"c%d\">", i % COLOURS).text(words(paths.get(i))).markup("</li>");
    }
    page.markup("</ul>");
  }

  private void draw(PageText page, DrivenPath path, int colour) {
    page.format("<path class=\"path c%d\" d=\"", colour);
    String next = "M";
    for (Vector3 place : path.places()) {
      page.format("%s%.1f %.1f", next, x(place), y(place));
      next = "L";
    }
    Vector3 start = path.places().getFirst();
    page.format("\"/><circle class=\"start c%d\" cx=\"%.1f\" cy=\"%.1f\" r=\"5\"/>", colour, x(start), y(start));
    page.format("<circle class=\"end c%d\" cx=\"%.1f\" cy=\"%.1f\" r=\"5\"/>", colour, x(path.end()), y(path.end()));
  }

  private double x(Vector3 place) {
    return WIDTH / 2.0 + (place.x() - (xs.getMin() + xs.getMax()) / 2) * scale;
  }

  private double y(Vector3 place) {
    return height / 2.0 - (place.y() - (ys.getMin() + ys.getMax()) / 2) * scale;
  }

  private void ruler(PageText page) {
    double metres = Math.pow(10, Math.floor(Math.log10(WIDTH / 4.0 / scale)));
    double length = metres * scale;
    page.format("<line class=\"ruler\" x1=\"%.1f\" y1=\"%d\" x2=\"%.1f\" y2=\"%d\"/>", WIDTH - MARGIN - length,
        height - 10, WIDTH - (double) MARGIN, height - 10);
    page.format("<text class=\"value\" x=\"%d\" y=\"%d\">", WIDTH - MARGIN, height - 15)
        .text(metres >= 1 ? String.format(Locale.ROOT, "%.0f m", metres) : String.format(Locale.ROOT, "%.2g m", metres))
        .markup("</text>");
  }

  private static String words(DrivenPath path) {
    Vector3 from = path.places().getFirst();
    String jumps = path.jumps() == 0 ? "" : path.jumps() == 1 ? ", one jump" : ", " + path.jumps() + " jumps";
    return String.format(Locale.ROOT, "%s: %.2f m%s, from (%.2f, %.2f) to (%.2f, %.2f)", path.port(), path.length(),
        jumps,
        from.x(), from.y(), path.end().x(), path.end().y());
  }
}
