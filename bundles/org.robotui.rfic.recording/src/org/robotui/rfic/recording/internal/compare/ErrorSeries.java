package org.robotui.rfic.recording.internal.compare;

/**
 * An error over time.
 *
 * @param name what is compared, for users
 * @param unit of the errors
 * @param times of the first recording, nanoseconds since 1970
 * @param values one for each time
 * @param figures what they come to
 */
public record ErrorSeries(String name, String unit, long[] times, double[] values, ErrorFigures figures) {
  static ErrorSeries of(String name, String unit, long[] times, double[] values) {
    return new ErrorSeries(name, unit, times, values, ErrorFigures.of(values));
  }
}
