package org.robotui.tests.bad;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;

/**
 * What to do wrong, and where.
 *
 * @param where the name of a method
 * @param misdeed what
 * @param from not earlier, of the monotonic clock
 * @param sign not before this file is there; empty where nothing is waited for
 * @param drives whether the component moves a robot before
 */
record Plan(String where, Misdeed misdeed, long from, String sign, boolean drives) {
  static final Schema SCHEMA = Schema.of(
      Setting.of("in", new ValueType.Text(), "nowhere", "In which method."),
      Setting.of("does", new ValueType.Text(), "nothing", "What."),
      Setting.of("after", new ValueType.Num(0, 1000, "s"), 0.0, "How long it behaves well."),
      Setting.of("sign", new ValueType.Text(), "", "The file without which it behaves well."),
      Setting.of("drives", new ValueType.Flag(), false, "Whether it moves the robot."),
      Setting.of("file", new ValueType.Text(), "", "Where a robot notes its commands."));

  static Plan of(Settings settings) {
    return new Plan(settings.text("in"), Misdeed.valueOf(settings.text("does").toUpperCase(Locale.ROOT)),
        System.nanoTime() + (long) (settings.number("after") * 1e9), settings.text("sign"), settings.flag("drives"));
  }

  /** Misbehaves, if it is the place and the time. */
  void at(String place) {
    if (place.equals(where) && System.nanoTime() >= from && (sign.isEmpty() || Files.exists(Path.of(sign)))) {
      misdeed.commit();
    }
  }

  boolean isAt(String place) {
    return place.equals(where);
  }
}
