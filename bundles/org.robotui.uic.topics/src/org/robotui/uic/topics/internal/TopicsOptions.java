package org.robotui.uic.topics.internal;

import java.time.Duration;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;

/**
 * What the view can be configured with.
 *
 * @param period the least time between two questions to the robot
 * @param measured how many topics may be measured at once
 * @param history how many messages of the echoed topic are kept
 */
public record TopicsOptions(Duration period, int measured, int history) {
  static final String PERIOD = "refresh_period";
  static final String MEASURED = "max_measured";
  static final String HISTORY = "history";

  private static final double MILLIS = 1000;

  public static Schema schema() {
    return Schema.of(
        Setting.of(PERIOD, new ValueType.Num(0.5, 60, "s"), 2.0,
            "How often the robot is asked what it has, while the view is seen."),
        Setting.of(MEASURED, new ValueType.Int(1, 100), 10L, "How many topics may be measured at once."),
        Setting.of(HISTORY, new ValueType.Int(1, 1000), 100L, "How many messages of the echoed topic are kept."));
  }

  public static TopicsOptions of(Settings settings) {
    return new TopicsOptions(Duration.ofMillis(Math.round(settings.number(PERIOD) * MILLIS)),
        Math.toIntExact(settings.integer(MEASURED)), Math.toIntExact(settings.integer(HISTORY)));
  }
}
