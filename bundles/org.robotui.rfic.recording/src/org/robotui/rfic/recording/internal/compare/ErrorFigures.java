package org.robotui.rfic.recording.internal.compare;

import java.util.Arrays;
import java.util.stream.DoubleStream;

/**
 * What errors come to.
 *
 * @param count how many they are
 * @param rmse root of the mean of their squares
 * @param mean their mean
 * @param median the middle one
 * @param deviation their standard deviation, of all of them
 * @param least the smallest one
 * @param most the largest one
 */
public record ErrorFigures(int count, double rmse, double mean, double median, double deviation, double least,
    double most) {
  /**
   * Of errors.
   *
   * @param errors some, at least one
   * @return their figures
   */
  public static ErrorFigures of(double[] errors) {
    double[] sorted = errors.clone();
    Arrays.sort(sorted);
    int count = sorted.length;
    double mean = DoubleStream.of(sorted).sum() / count;
    double median = count % 2 == 1 ? sorted[count / 2] : (sorted[count / 2 - 1] + sorted[count / 2]) / 2;
    return new ErrorFigures(count, root(sorted, 0), mean, median, root(sorted, mean), sorted[0], sorted[count - 1]);
  }

  private static double root(double[] values, double around) {
    return Math.sqrt(DoubleStream.of(values).map(each -> (each - around) * (each - around)).sum() / values.length);
  }
}
