package org.robotui.workbench.internal.timeline;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.api.replay.ComparisonReport.ComparedError;
import org.robotui.api.replay.ErrorCurve;
import org.robotui.ui.Figures;

/**
 * Where the errors of one kind lie in a chart.
 *
 * @param error of one kind, at least one of them
 * @param overWay whether they are drawn over the way gone, where that is known, in place of time
 */
record ErrorLine(ComparedError error, boolean overWay) {
  private static final int DIGITS = 5;

  ErrorLine {
    overWay = overWay && error.curve().knowsWay();
  }

  /** The lowest value of the scale: none below 0, where no error is. */
  double low() {
    return Math.min(0, error.least());
  }

  /** From one label of the scale of values to the next. */
  double step(int most) {
    return Figures.roundStep((Math.max(error.most(), error.rmse()) - error.least()) / most);
  }

  /** The highest value of the scale. */
  double high() {
    double high = Math.max(error.most(), error.rmse());
    return high > low() ? high : low() + 1;
  }

  /** From one label of the scale below to the next, in seconds or metres. */
  double stepAlong(int most) {
    return Figures.roundStep(length() / most);
  }

  private ErrorCurve curve() {
    return error.curve();
  }

  /** How far it is from the first error, in seconds or metres. */
  private double along(int at) {
    return overWay ? curve().gone(at) - curve().gone(0)
        : TimeScale.between(curve().time(0), curve().time(at)) / TimeWords.SECOND;
  }

  /** How long it is from the first error to the last, in seconds or metres. */
  double length() {
    return Math.max(1e-9, along(curve().size() - 1));
  }

  int x(Rectangle plot, int at) {
    return plot.x + (int) Math.round(along(at) / length() * plot.width);
  }

  int y(Rectangle plot, double value) {
    return plot.y + plot.height - (int) Math.round((value - low()) / (high() - low()) * plot.height);
  }

  /** The error that is nearest to a column. */
  int nearest(Rectangle plot, int x) {
    double wanted = (double) (x - plot.x) / plot.width * length();
    int low = 0;
    int high = curve().size() - 1;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (along(middle) < wanted) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low > 0 && wanted - along(low - 1) < along(low) - wanted ? low - 1 : low;
  }

  /** Of each column the smallest and the largest error, so that none is missed. */
  int[] polyline(Rectangle plot) {
    int[] points = new int[4 * (plot.width + 1)];
    int count = 0;
    int at = 0;
    while (at < curve().size()) {
      int column = x(plot, at);
      int first = at;
      while (at < curve().size() && (x(plot, at) == column)) {
        at++;
      }
      double[] values = IntStream.range(first, at).mapToDouble(curve()::error).toArray();
      points[count++] = column;
      points[count++] = y(plot, Arrays.stream(values).max().orElseThrow());
      points[count++] = column;
      points[count++] = y(plot, Arrays.stream(values).min().orElseThrow());
    }
    return Arrays.copyOf(points, count);
  }

  /** A number with the decimals that tell steps apart. */
  static String label(double value, double step) {
    return Figures.fixed(value, Math.clamp(-(long) Math.floor(Math.log10(step) + 1e-9), 0, 2 * DIGITS));
  }

  /** What an error is, for users. */
  String words(int at) {
    String time = TimeWords.seconds(curve().time(at) - curve().time(0));
    String way = curve().knowsWay() ? "  " + Figures.of(curve().gone(at), 2, "m") : "";
    return time + way + "  " + Figures.of(curve().error(at), DIGITS, error.unit());
  }
}
