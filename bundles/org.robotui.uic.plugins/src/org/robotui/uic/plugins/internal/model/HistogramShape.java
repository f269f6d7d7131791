package org.robotui.uic.plugins.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import org.robotui.data.control.Histogram;

/**
 * How a histogram is drawn: durations from left to right on a logarithmic axis, counts logarithmic too, since what
 * matters is the rare.
 *
 * @param bars those with anything in them
 * @param from the left end, nanoseconds, a power of ten
 * @param to the right end, nanoseconds, a power of ten
 */
public record HistogramShape(List<Bar> bars, double from, double to) {
  private static final double TEN = 10;
  private static final double LEAST = 100;

  /**
   * A bar.
   *
   * @param left share of the width where it begins, 0 to 1
   * @param right share of the width where it ends
   * @param height share of the height
   * @param count how many durations
   * @param lower the least duration in it, nanoseconds
   * @param upper where it ends, nanoseconds
   */
  public record Bar(double left, double right, double height, long count, double lower, double upper) {}

  /** Copies the list. */
  public HistogramShape {
    bars = List.copyOf(bars);
  }

  /** Shapes a histogram so that also a mark, for example of a period, lies within; 0 is none. */
  public static HistogramShape of(Histogram histogram, double mark) {
    List<double[]> filled = filled(histogram);
    double least = filled.isEmpty() ? LEAST : Math.max(LEAST, filled.getFirst()[0]);
    double most = Math.max(Math.max(mark, least), filled.isEmpty() ? LEAST * TEN : filled.getLast()[1]);
    double from = Math.pow(TEN, Math.floor(Math.log10(least)));
    double to = Math.max(from * TEN, Math.pow(TEN, Math.ceil(Math.log10(most))));
    long highest = filled.stream().mapToLong(b -> (long) b[2]).max().orElse(1);
    List<Bar> bars = filled.stream().map(b -> new Bar(share(b[0], from, to), share(b[1], from, to),
        Math.log1p(b[2]) / Math.log1p(highest), (long) b[2], b[0], b[1])).toList();
    return new HistogramShape(bars, from, to);
  }

  private static List<double[]> filled(Histogram histogram) {
    List<double[]> filled = new ArrayList<>();
    for (int i = 0; i < histogram.counts().size(); i++) {
      if (histogram.counts().get(i) > 0) {
        double lower = histogram.lower().get(i);
        double upper =
            i + 1 < histogram.lower().size() ? histogram.lower().get(i + 1) : Math.max(histogram.max(), lower * 2);
        filled.add(new double[]{lower, upper, histogram.counts().get(i)});
      }
    }
    return filled;
  }

  /** Where a duration lies, 0 to 1. */
  public double share(double nanos) {
    return share(nanos, from, to);
  }

  private static double share(double nanos, double from, double to) {
    return nanos <= from ? 0 : Math.min(1, Math.log(nanos / from) / Math.log(to / from));
  }

  /** The powers of ten, for the lines of the axis. */
  public double[] decades() {
    return DoubleStream.iterate(from, d -> d <= to * 1.001, d -> d * TEN).toArray();
  }
}
