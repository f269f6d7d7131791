package org.robotui.rfic.recording.internal.report;

import java.util.Arrays;

/** Numbers over time, of which each column of a figure keeps the lowest and the highest. For one thread. */
final class BinnedSeries {
  private final String name;
  private final String unit;
  private final TimeBins bins;
  private final double[] low;
  private final double[] high;
  private double sum;
  private long count;

  BinnedSeries(String name, String unit, TimeBins bins) {
    this.name = name;
    this.unit = unit;
    this.bins = bins;
    low = new double[bins.count()];
    high = new double[bins.count()];
    Arrays.fill(low, Double.POSITIVE_INFINITY);
    Arrays.fill(high, Double.NEGATIVE_INFINITY);
  }

  /** Numbers that are none are left out. */
  void take(long time, double value) {
    if (Double.isFinite(value)) {
      int bin = bins.of(time);
      low[bin] = Math.min(low[bin], value);
      high[bin] = Math.max(high[bin], value);
      sum += value;
      count++;
    }
  }

  String name() {
    return name;
  }

  String unit() {
    return unit;
  }

  TimeBins bins() {
    return bins;
  }

  boolean isEmpty() {
    return count == 0;
  }

  boolean has(int bin) {
    return low[bin] <= high[bin];
  }

  double low(int bin) {
    return low[bin];
  }

  double high(int bin) {
    return high[bin];
  }

  double lowest() {
    return Arrays.stream(low).min().orElseThrow();
  }

  double highest() {
    return Arrays.stream(high).max().orElseThrow();
  }

  double mean() {
    return sum / count;
  }
}
