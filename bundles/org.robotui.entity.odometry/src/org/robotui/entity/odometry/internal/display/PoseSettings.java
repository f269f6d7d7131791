package org.robotui.entity.odometry.internal.display;

import java.util.List;
import java.util.stream.Stream;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.entity.odometry.internal.colored.ColorBy;
import org.robotui.gl.display.ColorSetting;

/** What all displays of poses can be set to. */
final class PoseSettings {
  /** Poses that stay at most. */
  static final int MOST = 10_000;

  static final String WAY = "way_length";

  private PoseSettings() {}

  /** Of poses that may make a way. */
  static Schema schema(String color, long keep, double length) {
    return ColorBy.with(Stream.concat(settings(color, keep, length), Stream.of(
        Setting.of(WAY, new ValueType.Num(0, 100_000, "m"), 100.0, "With color_by: how much of the way is shown.")))
        .toArray(Setting[]::new));
  }

  /** Of a pose that makes no way. */
  static Schema single(String color, double length) {
    return Schema.of(settings(color, 1, length).toArray(Setting[]::new));
  }

  private static Stream<Setting> settings(String color, long keep, double length) {
    return Stream.of(
        Setting.of("shape", new ValueType.Choice(List.of("arrows", "axes")), "arrows", "How a pose is shown."),
        ColorSetting.of("color", color, "The colour of arrows."),
        Setting.of("opacity", new ValueType.Num(0, 1, ""), 1.0, "0 invisible to 1 opaque."),
        Setting.of("length", new ValueType.Num(0.001, 1000, "m"), length, "Length of arrows and axes."),
        Setting.of("keep", new ValueType.Int(1, MOST), keep, "How many poses stay."),
        Setting.of("distance", new ValueType.Num(0, 1000, "m"), 0.1,
            "A pose is added that is farther than this from the last one, ..."),
        Setting.of("angle", new ValueType.Num(0, 360, "deg"), 6.0, "... or turned more than this."),
        Setting.of("covariance", new ValueType.Flag(), true,
            "Whether the uncertainty of the newest is shown: an ellipsoid and a cone."),
        Setting.of("deviations", new ValueType.Num(0.1, 10, ""), 1.0, "How many standard deviations they reach."),
        ColorSetting.of("covariance_color", "#cc33cc59", "The colour of the uncertainty of the place."),
        ColorSetting.of("heading_color", "#ffff8059", "The colour of the uncertainty of the heading."));
  }
}
