package org.robotui.rfic.recording.internal.compare;

import java.util.Arrays;
import java.util.function.LongToDoubleFunction;
import org.robotui.api.replay.ComparisonReport.ComparedError;
import org.robotui.api.replay.ErrorCurve;

/**
 * An error over time.
 *
 * @param name what is compared, for users
 * @param unit of the errors
 * @param times of the first recording, nanoseconds since 1970
 * @param gone how far its robot had gone at each time, metres; empty where that is not known
 * @param values one for each time
 * @param figures what they come to
 */
public record ErrorSeries(String name, String unit, long[] times, double[] gone, double[] values,
    ErrorFigures figures) {
  static ErrorSeries of(String name, String unit, long[] times, double[] values) {
    return new ErrorSeries(name, unit, times, new double[0], values, ErrorFigures.of(values));
  }

  /** The same, over the way gone as well. */
  ErrorSeries over(LongToDoubleFunction way) {
    return new ErrorSeries(name, unit, times, Arrays.stream(times).mapToDouble(way).toArray(), values, figures);
  }

  /** The same as others know it, with something added to the times. */
  ComparedError compared(long offset) {
    return new ComparedError(name, unit, figures.count(), figures.rmse(), figures.mean(), figures.median(),
        figures.deviation(), figures.least(), figures.most(),
        new ErrorCurve(Arrays.stream(times).map(time -> time + offset).toArray(), gone, values));
  }
}
