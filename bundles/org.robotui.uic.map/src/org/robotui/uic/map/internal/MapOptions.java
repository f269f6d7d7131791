package org.robotui.uic.map.internal;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.ui.display.DisplayEntry;
import org.robotui.ui.display.DisplayKind;
import org.robotui.ui.display.DisplaySpec;
import org.robotui.ui.layer.LayerStack;
import org.robotui.ui.scene.KeptViewport;

/**
 * The settings of the map. Those that name kinds of layers say how layers begin that nobody has listed.
 *
 * @param fixedFrame what is drawn at rest; none to choose by itself
 * @param follow whether the robot stays in the middle
 * @param list whether the list of layers is seen
 * @param hiddenKinds kinds of layers that begin hidden
 * @param hidden ids of single layers that begin hidden
 * @param beginnings settings with which layers of a kind begin
 * @param robotRadius of a robot without a footprint, metres
 */
public record MapOptions(
    Optional<String> fixedFrame,
    boolean follow,
    boolean list,
    Set<String> hiddenKinds,
    Set<String> hidden,
    Map<String, Map<String, Object>> beginnings,
    double robotRadius) {
  public static final String FIXED_FRAME = "fixed_frame";
  public static final String FOLLOW = "follow";
  public static final String LIST = "list";
  public static final String HIDDEN = "hidden";
  public static final String SHOW_FAN = "show_fan";
  public static final String SHOW_UNCERTAINTY = "show_uncertainty";
  public static final String AUTO = "auto";

  /** The kinds that have a setting of their own, and what it is about. */
  private static final Map<String, String> KINDS = kinds();
  private static final TextRule LAYER = TextRule.matching("a layer, such as scan:base.rear_scan", "[^:]+:.+");
  private static final String TRAIL_LENGTH = "trail_length";
  private static final String ROBOT_RADIUS = "robot_radius";

  private static Map<String, String> kinds() {
    Map<String, String> kinds = new LinkedHashMap<>();
    kinds.put("grid", "grid");
    kinds.put("map", "map");
    kinds.put("sonar", "sonar");
    kinds.put("scan", "laser scan");
    kinds.put("trail", "trail");
    kinds.put("path", "planned path");
    kinds.put("pose", "pose estimate");
    kinds.put("robot", "robot");
    kinds.put("bumper", "bumpers");
    return Map.copyOf(kinds);
  }

  /** The setting that shows or hides layers of a kind. */
  public static String show(String kind) {
    return "show_" + kind;
  }

  /** What the map can be configured with, whichever layers there are. */
  public static Schema schema() {
    return schema(List.of());
  }

  /** The same with kinds of layers to choose from. */
  static Schema schema(List<DisplayKind> kinds) {
    List<Setting> settings = new ArrayList<>();
    settings.add(Setting.of(FIXED_FRAME, new ValueType.Text(TextRule.FRAME), AUTO,
        "The fixed frame; 'auto' takes map, else odom, else the first root."));
    settings.add(Setting.of(FOLLOW, new ValueType.Flag(), false, "Keep the robot in the middle."));
    settings.add(Setting.of(LayerStack.LAYERS, DisplayEntry.list("layer", "scan", kinds), List.of(),
        "Layers, the topmost first; the settings below say how those begin that are not listed."));
    settings.add(Setting.of(DisplayEntry.AUTOMATIC, new ValueType.Flag(), true,
        "Show what the robot offers beside the layers that are listed."));
    settings.add(KeptViewport.setting());
    settings.add(Setting.of(LIST, new ValueType.Flag(), false, "Whether the list of layers is seen."));
    KINDS.keySet().stream().sorted()
        .forEach(
            kind -> settings.add(Setting.of(show(kind), new ValueType.Flag(), true, "Show: " + KINDS.get(kind) + ".")));
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
    Optional<String> fixed = Optional.of(s.text(FIXED_FRAME).strip()).filter(f -> !f.isEmpty() && !f.equals(AUTO));
    Map<String, Map<String, Object>> beginnings = Map.of(
        "scan", Map.of("free_space", s.flag(SHOW_FAN)),
        "trail", Map.of("uncertainty", s.flag(SHOW_UNCERTAINTY), "length", s.number(TRAIL_LENGTH)),
        "robot", Map.of("radius", s.number(ROBOT_RADIUS)));
    return new MapOptions(fixed, s.flag(FOLLOW), s.flag(LIST),
        KINDS.keySet().stream().filter(kind -> !s.flag(show(kind))).collect(Collectors.toUnmodifiableSet()),
        Set.copyOf(s.list(HIDDEN).stream().map(Object::toString).toList()), beginnings, s.number(ROBOT_RADIUS));
  }

  /** A layer that nobody has listed, as the settings have it begin. */
  public DisplaySpec begin(DisplaySpec spec) {
    return spec.with(beginnings.getOrDefault(spec.type(), Map.of()))
        .show(spec.shown() && !hiddenKinds.contains(spec.type()) && !hidden.contains(spec.id()));
  }
}
