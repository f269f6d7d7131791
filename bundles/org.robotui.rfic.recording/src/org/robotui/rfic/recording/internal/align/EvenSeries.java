package org.robotui.rfic.recording.internal.align;

import java.util.Arrays;
import java.util.List;

/**
 * A series at even distances in time, without its mean.
 *
 * @param start time of the first value
 * @param step distance of two values, nanoseconds
 * @param values what lies between samples is on the line between them
 */
record EvenSeries(long start, long step, double[] values) {
  /** From the first sample to the last one. */
  static EvenSeries of(List<TurningRates.Sample> samples, long step) {
    long start = samples.getFirst().time();
    int count = (int) ((samples.getLast().time() - start) / step) + 1;
    double[] values = new double[count];
    int next = 0;
    for (int i = 0; i < count; i++) {
      long time = start + i * step;
      while (next < samples.size() - 1 && samples.get(next + 1).time() <= time) {
        next++;
      }
      values[i] = at(samples, next, time);
    }
    double mean = Arrays.stream(values).average().orElse(0);
    return new EvenSeries(start, step, Arrays.stream(values).map(each -> each - mean).toArray());
  }

  private static double at(List<TurningRates.Sample> samples, int before, long time) {
    TurningRates.Sample one = samples.get(before);
    if (before + 1 >= samples.size() || samples.get(before + 1).time() == one.time()) {
      return one.value();
    }
    TurningRates.Sample two = samples.get(before + 1);
    double part = (double) (time - one.time()) / (two.time() - one.time());
    return one.value() + Math.clamp(part, 0, 1) * (two.value() - one.value());
  }

  int size() {
    return values.length;
  }

  /**
   * How alike two series are where one is moved.
   *
   * @param other the one that is moved
   * @param lag by how many steps its values come later in this one
   * @param least over how many values at least
   * @return from -1 to 1; not a number where they overlap by too little, or one of them does not change there
   */
  double correlation(EvenSeries other, int lag, int least) {
    int from = Math.max(0, lag);
    int to = Math.min(size(), other.size() + lag);
    if (to - from < least) {
      return Double.NaN;
    }
    double product = 0;
    double own = 0;
    double others = 0;
    for (int i = from; i < to; i++) {
      double a = values[i];
      double b = other.values[i - lag];
      product += a * b;
      own += a * a;
      others += b * b;
    }
    return product / Math.sqrt(own * others);
  }
}
