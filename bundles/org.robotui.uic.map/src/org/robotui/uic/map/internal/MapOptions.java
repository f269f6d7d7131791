package org.robotui.uic.map.internal;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;

/**
 * The settings of the map.
 *
 * @param fixedFrame what is drawn at rest; none to choose by itself
 * @param follow whether the robot stays in the middle
 * @param shown kinds of layers to draw
 * @param hidden ids of single layers not to draw
 * @param fan whether the space that laser beams crossed is drawn
 * @param uncertainty whether the ellipse of the odometry is drawn
 * @param trailLength of the way to keep, metres
 * @param robotRadius of a robot without a footprint, metres
 */
public record MapOptions(
    Optional<String> fixedFrame,
    boolean follow,
    Set<Kind> shown,
    Set<String> hidden,
    boolean fan,
    boolean uncertainty,
    double trailLength,
    double robotRadius) {
  public static final String FIXED_FRAME = "fixed_frame";
  public static final String FOLLOW = "follow";
  public static final String HIDDEN = "hidden";
  public static final String SHOW_FAN = "show_fan";
  public static final String SHOW_UNCERTAINTY = "show_uncertainty";
  public static final String AUTO = "auto";

  private static final TextRule LAYER = TextRule.matching("a layer, such as scan:base.rear_scan", "[^:]+:.+");
  private static final String TRAIL_LENGTH = "trail_length";
  private static final String ROBOT_RADIUS = "robot_radius";

  /** What the map can be configured with. */
  public static Schema schema() {
    List<Setting> settings = new ArrayList<>();
    settings.add(Setting.of(FIXED_FRAME, new ValueType.Text(TextRule.FRAME), AUTO,
        "The fixed frame; 'auto' takes map, else odom, else the first root."));
    settings.add(Setting.of(FOLLOW, new ValueType.Flag(), false, "Keep the robot in the middle."));
    for (Kind kind : Kind.values()) {
      settings.add(Setting.of(kind.setting(), new ValueType.Flag(), true,
          "Show: " + kind.label().toLowerCase(Locale.ROOT) + "."));
    }
    settings.add(Setting.of(SHOW_FAN, new ValueType.Flag(), true, "Show the free space that laser beams crossed."));
    settings.add(Setting.of(SHOW_UNCERTAINTY, new ValueType.Flag(), false,
        "Show the uncertainty of odometry: two standard deviations around its position."));
    settings.add(Setting.of(HIDDEN, new ValueType.ListOf(new ValueType.Text(LAYER)), List.of(),
        "Single layers not to show, as kind:component.port, for example scan:base.rear_scan."));
    settings.add(Setting.of(TRAIL_LENGTH, new ValueType.Num(0, 100_000, "m"), 30.0, "How much of the trail to show."));
    settings.add(Setting.of(ROBOT_RADIUS, new ValueType.Num(0.01, 20, "m"), 0.25,
        "Size of a robot whose footprint is not known."));
    return new Schema(settings);
  }

  /** Reads checked settings. */
  public static MapOptions of(Settings s) {
    Set<Kind> shown = EnumSet.noneOf(Kind.class);
    for (Kind kind : Kind.values()) {
      if (s.flag(kind.setting())) {
        shown.add(kind);
      }
    }
    Set<String> hidden = Set.copyOf(s.list(HIDDEN).stream().map(Object::toString).toList());
    Optional<String> fixed = Optional.of(s.text(FIXED_FRAME).strip()).filter(f -> !f.isEmpty() && !f.equals(AUTO));
    return new MapOptions(fixed, s.flag(FOLLOW), Set.copyOf(shown), hidden, s.flag(SHOW_FAN),
        s.flag(SHOW_UNCERTAINTY), s.number(TRAIL_LENGTH), s.number(ROBOT_RADIUS));
  }

  /** Whether a layer is to be drawn. */
  public boolean shows(Kind kind, String layer) {
    return shown.contains(kind) && !hidden.contains(layer);
  }
}
