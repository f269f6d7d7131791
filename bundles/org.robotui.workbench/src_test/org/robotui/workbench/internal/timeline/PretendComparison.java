package org.robotui.workbench.internal.timeline;

import java.util.List;
import org.robotui.api.replay.ComparisonReport;
import org.robotui.api.replay.ComparisonReport.ComparedError;
import org.robotui.api.replay.ErrorCurve;
import org.robotui.api.replay.RecordingComparison;

/** Comparisons that come to what they are given. */
final class PretendComparison {
  /** Two ways that are some centimetres apart. */
  static final RecordingComparison CIRCLE = wish -> {
    if (!wish.topic().startsWith("odom")) {
      throw new IllegalArgumentException("keira.mcap has no topic '" + wish.topic() + "'; it has odom, scan");
    }
    return new ComparisonReport(1834, 2000, 1834, List.of(
        new ComparedError("APE position", "m", 1834, 0.0263, 0.0253, 0.02624, 0.0071, 0.01377, 0.03675,
            curve(1834, 0.025, 0.0115)),
        new ComparedError("APE rotation", "deg", 1834, 1.6935, 1.5551, 1.4092, 0.6706, 0.1327, 3.0237,
            curve(1834, 1.55, 1.45)),
        new ComparedError("RPE position per pose", "m", 1833, 0.0091, 0.008, 0.0072, 0.0043, 0.001, 0.0323,
            curve(1833, 0.016, 0.015)),
        new ComparedError("RPE rotation per pose", "deg", 1833, 0.3843, 0.3565, 0.3037, 0.1435, 0.207, 0.9151,
            curve(1833, 0.55, 0.35))),
        List.of());
  };

  private PretendComparison() {}

  /** Errors of four minutes, in waves. */
  private static ErrorCurve curve(int count, double middle, double high) {
    long[] times = new long[count];
    double[] gone = new double[count];
    double[] errors = new double[count];
    for (int i = 0; i < count; i++) {
      times[i] = PretendTimeline.BEGIN + i * 130 * PretendTimeline.SECOND / 1000;
      gone[i] = 0.03 * i;
      errors[i] = middle + high * Math.sin(i / 70.0) * Math.cos(i / 11.0);
    }
    return new ErrorCurve(times, gone, errors);
  }
}
