package org.robotui.uic.plot.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.robotui.ui.Figures;
import org.robotui.uic.plot.internal.trace.Samples;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * How many samples have which values: bins of one width that begin at multiples of it. The width is that of Freedman
 * and Diaconis (twice the distance of the quartiles, divided by the cube root of the count) as a round number; whole
 * numbers within a small range have a bin each. Samples that are no number, or beyond 1e300, do not count.
 *
 * @param low where the first bin begins
 * @param width of each bin; a value at its upper end belongs to the next
 * @param counts from the lowest bin to the highest; empty where there is no sample
 */
public record ValueBins(double low, double width, List<Long> counts) {
  /** Bins at most. */
  public static final int MOST = 200;

  /** No samples. */
  public static final ValueBins NONE = new ValueBins(0, 1, List.of());

  private static final int FINE = 4096;
  private static final double SCOTT = 3.5;
  /** The difference of any two is still a number. */
  private static final double LARGEST = 1e300;

  public ValueBins {
    counts = List.copyOf(counts);
  }

  /** What the samples are, by a look at all of them. */
  private record Shape(long count, double min, double max, double squares, double mean, boolean whole) {
    double deviation() {
      return Math.sqrt(squares / count);
    }
  }

  /** Counts the samples of a span, ends included. */
  public static ValueBins of(Samples samples, TimeSpan span) {
    double[] values = IntStream.range(samples.indexOf(span.from()), samples.indexOf(span.to() + 1))
        .mapToDouble(samples::value).filter(value -> Math.abs(value) < LARGEST).toArray();
    if (values.length == 0) {
      return NONE;
    }
    Shape shape = shape(values);
    if (shape.whole && shape.max - shape.min < MOST) {
      return count(values, shape, 1, shape.min - 0.5);
    }
    double width = nearest(width(values, shape));
    while (bins(shape, width, start(shape, width)) > MOST) {
      width = Figures.roundStep(width * 1.5);
    }
    return count(values, shape, width, start(shape, width));
  }

  /** The round number that is nearest by its ratio. */
  private static double nearest(double width) {
    double above = Figures.roundStep(width);
    double below = Figures.roundStep(above / 2.6);
    return above / width < width / below ? above : below;
  }

  /** How many samples there are. */
  public long samples() {
    return counts.stream().mapToLong(Long::longValue).sum();
  }

  /** The most samples of a bin. */
  public long most() {
    return counts.stream().mapToLong(Long::longValue).max().orElse(0);
  }

  /** Where a bin begins, and the one before it ends. */
  public double edge(int bin) {
    return low + bin * width;
  }

  private static Shape shape(double[] values) {
    double min = Double.POSITIVE_INFINITY;
    double max = Double.NEGATIVE_INFINITY;
    double mean = 0;
    double squares = 0;
    boolean whole = true;
    long count = 0;
    for (double value : values) {
      min = Math.min(min, value);
      max = Math.max(max, value);
      whole &= value == Math.rint(value);
      double before = mean;
      mean += (value - mean) / ++count;
      squares += (value - before) * (value - mean);
    }
    return new Shape(count, min, max, squares, mean, whole);
  }

  /** Where the quartiles are one, as of a value that mostly stands, by the deviation (Scott). */
  private static double width(double[] values, Shape shape) {
    double root = Math.cbrt(shape.count);
    double middle = 2 * quartiles(values, shape) / root;
    double width = middle > 0 ? middle : SCOTT * shape.deviation() / root;
    double least = Math.max(Math.ulp(Math.max(Math.abs(shape.min), Math.abs(shape.max))) * 4, Double.MIN_NORMAL);
    return width > 0 && Double.isFinite(width) ? Math.max(least, width) : Math.max(least, Math.abs(shape.min) / MOST);
  }

  /** The distance of the quartiles, as exact as fine bins tell it. */
  private static double quartiles(double[] values, Shape shape) {
    double range = shape.max - shape.min;
    if (!(range > 0) || !Double.isFinite(range)) {
      return 0;
    }
    long[] fine = new long[FINE];
    for (double value : values) {
      fine[(int) Math.min(FINE - 1, (value - shape.min) / range * FINE)]++;
    }
    return (quantile(fine, 0.75 * shape.count) - quantile(fine, 0.25 * shape.count)) / FINE * range;
  }

  private static double quantile(long[] fine, double wanted) {
    double passed = 0;
    for (int i = 0; i < fine.length; i++) {
      if (passed + fine[i] >= wanted) {
        return i + (wanted - passed) / Math.max(1, fine[i]);
      }
      passed += fine[i];
    }
    return fine.length;
  }

  private static double start(Shape shape, double width) {
    return Math.floor(shape.min / width) * width;
  }

  private static double bins(Shape shape, double width, double low) {
    return Math.floor((shape.max - low) / width) + 1;
  }

  private static ValueBins count(double[] values, Shape shape, double width, double low) {
    int bins = (int) Math.clamp(bins(shape, width, low), 1, MOST);
    long[] counts = new long[bins];
    for (double value : values) {
      counts[(int) Math.clamp(Math.floor((value - low) / width), 0, bins - 1.0)]++;
    }
    List<Long> all = new ArrayList<>();
    for (long each : counts) {
      all.add(each);
    }
    return new ValueBins(low, width, all);
  }
}
