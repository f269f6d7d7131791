package org.robotui.workbench.internal.timeline;

import java.util.List;
import org.robotui.api.replay.ComparisonReport;
import org.robotui.api.replay.ComparisonReport.ComparedError;
import org.robotui.api.replay.RecordingComparison;

/** Comparisons that come to what they are given. */
final class PretendComparison {
  /** Two ways that are some centimetres apart. */
  static final RecordingComparison CIRCLE = wish -> {
    if (!wish.topic().startsWith("odom")) {
      throw new IllegalArgumentException("keira.mcap has no topic '" + wish.topic() + "'; it has odom, scan");
    }
    return new ComparisonReport(1834, 2000, 1834, List.of(
        new ComparedError("APE position", "m", 1834, 0.0263, 0.0253, 0.02624, 0.0071, 0.01377, 0.03675),
        new ComparedError("APE rotation", "deg", 1834, 1.6935, 1.5551, 1.4092, 0.6706, 0.1327, 3.0237),
        new ComparedError("RPE position per pose", "m", 1833, 0.0091, 0.008, 0.0072, 0.0043, 0.001, 0.0323),
        new ComparedError("RPE rotation per pose", "deg", 1833, 0.3843, 0.3565, 0.3037, 0.1435, 0.207, 0.9151)),
        List.of());
  };

  private PretendComparison() {}
}
