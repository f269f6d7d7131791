package org.robotui.uic.plot.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.uic.plot.internal.trace.Series;
import org.robotui.uic.plot.internal.trace.TimeSpan;

class ValueBinsTest {
  private static final TimeSpan ALL = new TimeSpan(0, 1_000_000);

  private static Series series(double... values) {
    Series series = new Series(1_000_000);
    for (int i = 0; i < values.length; i++) {
      series.add(i, values[i]);
    }
    return series;
  }

  private static ValueBins bins(double... values) {
    return ValueBins.of(series(values).samples(), ALL);
  }

  @Test
  void theWidthIsThatOfFreedmanAndDiaconisAsARoundNumber() {
    Random random = new Random(1);
    ValueBins bins = bins(DoubleStream.generate(random::nextGaussian).limit(1000).toArray());
    assertEquals(0.2, bins.width()); // 2 * 1.349 / 10 = 0.27, which is nearer to 0.2 than to 0.5
    assertEquals(1000, bins.samples());
    assertEquals(Math.rint(bins.low() * 5), bins.low() * 5, 1e-9);
    assertTrue(bins.counts().size() > 24 && bins.counts().size() < 45, bins.toString());
  }

  @Test
  void wholeNumbersHaveABinEach() {
    ValueBins bins = bins(0, 1, 1, 3, 3, 3);
    assertEquals(new ValueBins(-0.5, 1, List.of(1L, 2L, 0L, 3L)), bins);
  }

  @Test
  void theNumberOfBinsIsBounded() {
    double[] values = DoubleStream.concat(DoubleStream.iterate(0, x -> x + 1e-6).limit(10_000), DoubleStream.of(1e9))
        .toArray();
    ValueBins bins = bins(values);
    assertTrue(bins.counts().size() <= ValueBins.MOST, bins.counts().size() + " bins");
    assertEquals(values.length, bins.samples());
  }

  @Test
  void whatIsNoNumberDoesNotCount() {
    assertEquals(ValueBins.NONE, bins());
    assertEquals(ValueBins.NONE, bins(Double.NaN, Double.POSITIVE_INFINITY));
    assertEquals(2, bins(0.25, Double.NaN, 0.75).samples());
  }

  @Test
  void valuesThatHardlyDifferAndTheLargestAreCounted() {
    for (double[] values : List.of(new double[]{0.1, 0.1, 0.1}, new double[]{9e299, -9e299, 3.5},
        new double[]{0, 5e299},
        new double[]{1.5, Math.nextUp(1.5)},
        new double[]{Double.MIN_VALUE, 0.5 * Double.MIN_NORMAL}, new double[]{1e17 + 0.5, 1e17 + 64, 0.5})) {
      ValueBins bins = bins(values);
      assertEquals(values.length, bins.samples(), bins.toString());
      assertTrue(bins.counts().size() <= ValueBins.MOST && bins.width() > 0, bins.toString());
    }
  }

  @Test
  void onlyTheSpanCountsAndTheTableHasAllDigits() {
    ValueBins bins = ValueBins.of(series(1, 2, 3, 9).samples(), new TimeSpan(1, 2));
    assertEquals(2, bins.samples());
    TraceView trace = new TraceView(TraceSpec.of("base./odom:linear.x"), 0, "linear.x", "", "m/s", Optional.empty(),
        new InputState.Live(1, 0), Optional.empty(), List.of(), 0);
    assertEquals("trace,unit,from,to,count,share\nbase./odom:linear.x,m/s,1.5,2.5,1,0.5\n"
        + "base./odom:linear.x,m/s,2.5,3.5,1,0.5\n", BinnedTrace.table(List.of(new BinnedTrace(trace, bins)), ","));
  }
}
