package org.robotui.rfic.xbot.internal;

import java.time.Duration;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;

/**
 * Which control is attached to, and how often it is read.
 *
 * @param robot the name of its robot
 * @param period between two readings of the state
 */
record XbotSettings(String robot, Duration period) {
  private static final double SLOWEST_HZ = 1;
  private static final double FASTEST_HZ = 500;
  private static final double RATE_HZ = 50;
  private static final double NANOS = 1e9;

  static final Schema SCHEMA = Schema.of(
      Setting.optional("robot", new ValueType.Text(),
          "name of the robot that the control was started for; else that of the robot here"),
      Setting.of("rate", new ValueType.Num(SLOWEST_HZ, FASTEST_HZ, "Hz"), RATE_HZ,
          "how often the state of the joints is read"));

  static XbotSettings of(Settings settings, String robot) {
    return new XbotSettings(settings.has("robot") ? settings.text("robot") : robot,
        Duration.ofNanos((long) (NANOS / settings.number("rate"))));
  }
}
