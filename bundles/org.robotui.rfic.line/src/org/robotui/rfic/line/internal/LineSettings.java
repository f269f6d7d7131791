package org.robotui.rfic.line.internal;

import java.time.Duration;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.net.socket.HostPort;

/**
 * What users can set.
 *
 * @param robot where it listens
 * @param silence how long it may say nothing
 */
record LineSettings(HostPort robot, Duration silence) {

  /** The form of the settings is made from it, configurations are checked by it, and each setting has its help. */
  static final Schema SCHEMA = Schema.of(
      Setting.of("host", new ValueType.Text(TextRule.HOST), "localhost", "name or address of the robot"),
      Setting.of("port", new ValueType.Int(1, 65_535), 4000L, "port on which the robot listens"),
      Setting.of("silence", new ValueType.Num(0.5, 60, "s"), 2.0,
          "a robot that says nothing for so long counts as lost"));

  static LineSettings of(Settings settings) {
    return new LineSettings(new HostPort(settings.text("host"), (int) settings.integer("port")),
        Duration.ofMillis(Math.round(settings.number("silence") * 1000)));
  }
}
