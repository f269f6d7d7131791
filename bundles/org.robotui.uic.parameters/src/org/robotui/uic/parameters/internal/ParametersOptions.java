package org.robotui.uic.parameters.internal;

import java.time.Duration;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;

/**
 * What the view can be configured with.
 *
 * @param names the least time between two questions for names
 * @param values the least time between two questions for what is seen: values, and settings of a running program
 */
public record ParametersOptions(Duration names, Duration values) {
  static final String NAMES = "names_period";
  static final String VALUES = "values_period";

  private static final double MILLIS = 1000;

  public static Schema schema() {
    return Schema.of(
        Setting.of(NAMES, new ValueType.Num(1, 600, "s"), 5.0,
            "How often the robot is asked which parameters it has, while the view is seen."),
        Setting.of(VALUES, new ValueType.Num(0.5, 600, "s"), 3.0, "How often what is seen is read again."));
  }

  public static ParametersOptions of(Settings settings) {
    return new ParametersOptions(period(settings, NAMES), period(settings, VALUES));
  }

  private static Duration period(Settings settings, String name) {
    return Duration.ofMillis(Math.round(settings.number(name) * MILLIS));
  }
}
