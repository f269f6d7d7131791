package org.robotui.rfic.recording.internal.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.robotui.api.replay.TimeRange;

/**
 * The time of a recording as an axis, in seconds or minutes from its beginning.
 *
 * @param range what is shown
 * @param origin the beginning of the recording
 * @param left where the axis begins in a figure
 * @param width how wide it is
 */
record TimeAxis(TimeRange range, long origin, double left, double width) {
  private static final double[] STEPS =
      {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 14400, 43200};
  private static final int MOST_TICKS = 9;
  private static final double SECOND = 1e9;

  double x(long time) {
    return left + width * (time - range.start()) / Math.max(1, range.length());
  }

  /** Draws lines through a figure, and their times below it. */
  void draw(PageText page, double top, double bottom) {
    for (double seconds : ticks()) {
      double x = x(origin + Math.round(seconds * SECOND));
      page.format("<line class=\"grid\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>", x, top, x, bottom);
      page.format("<text class=\"tick\" x=\"%.1f\" y=\"%.1f\">", x, bottom + 13).text(words(seconds)).markup("</text>");
    }
  }

  private List<Double> ticks() {
    double length = range.length() / SECOND;
    double step = STEPS[STEPS.length - 1];
    for (double each : STEPS) {
      if (length / each <= MOST_TICKS) {
        step = each;
        break;
      }
    }
    double begin = (range.start() - origin) / SECOND;
    List<Double> all = new ArrayList<>();
    for (double at = Math.ceil(begin / step) * step; at <= begin + length && all.size() < 2 * MOST_TICKS; at += step) {
      all.add(at);
    }
    return all;
  }

  /** How long something takes, with the unit of its largest part. */
  static String length(double seconds) {
    return words(seconds) + (seconds < 60 ? "" : seconds < 3600 ? " min" : " h");
  }

  /** Seconds from the beginning, with minutes and hours where there are some. */
  static String words(double seconds) {
    long whole = (long) Math.floor(seconds);
    if (whole < 60) {
      return String.format(Locale.ROOT, seconds == whole ? "%.0f s" : "%.2f s", seconds);
    }
    String minutes = String.format(Locale.ROOT, "%d:%02d", whole / 60 % 60, whole % 60);
    return whole < 3600 ? minutes
        : String.format(Locale.ROOT, "%d:%02d:%02d", whole / 3600, whole / 60 % 60, whole % 60);
  }
}
