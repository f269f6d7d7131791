package org.robotui.sim.internal.ros;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.robotui.ros.msgs.dynamic_reconfigure.BoolParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.Config;
import org.robotui.ros.msgs.dynamic_reconfigure.ConfigDescription;
import org.robotui.ros.msgs.dynamic_reconfigure.DoubleParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.Group;
import org.robotui.ros.msgs.dynamic_reconfigure.GroupState;
import org.robotui.ros.msgs.dynamic_reconfigure.IntParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.ParamDescription;
import org.robotui.sim.internal.Tuning;
import org.robotui.sim.internal.Tuning.Style;
import org.robotui.sim.internal.message.DriveLimit;
import org.robotui.sim.internal.robot.DriveLimits;

/** The robot's tuning as messages of dynamic_reconfigure. */
final class TuningMessages {
  private TuningMessages() {}

  static ConfigDescription description(Tuning initial) {
    Group all = new Group("Default", "", List.of(
        parameter(DriveLimit.STYLE, "int", DriveLimit.STYLE_DESCRIPTION, styles()),
        parameter(DriveLimit.WALKS, "bool", DriveLimit.WALKS_DESCRIPTION, "")), 0, 0);
    Group limits = new Group("Limits", "collapse", DriveLimit.ALL.stream()
        .map(limit -> parameter(limit.name(), "double", limit.description(), "")).toList(), 0, 1);
    Style[] styles = Style.values();
    return new ConfigDescription(
        List.of(all, limits),
        config(new Tuning(DriveLimit.limits(DriveLimit::highest), styles[styles.length - 1], true)),
        config(new Tuning(DriveLimit.limits(DriveLimit::lowest), styles[0], false)),
        config(initial));
  }

  private static ParamDescription parameter(String name, String type, String description, String editMethod) {
    return new ParamDescription(name, type, 1, description, editMethod);
  }

  /** The choices in the form that dynamic_reconfigure's generator gives them. */
  private static String styles() {
    return Arrays.stream(Style.values())
        .map(style -> "{'name': '" + title(style) + "', 'type': 'int', 'value': " + style.ordinal()
            + ", 'description': '"
            + style.description() + "', 'ctype': 'int', 'cconsttype': 'const int', 'srcline': 0, 'srcfile': ''}")
        .collect(
            Collectors.joining(", ", "{'enum': [", "], 'enum_description': '" + DriveLimit.STYLE_DESCRIPTION + "'}"));
  }

  private static String title(Style style) {
    return style.name().charAt(0) + style.name().substring(1).toLowerCase(Locale.ROOT);
  }

  static Config config(Tuning tuning) {
    return new Config(
        List.of(new BoolParameter(DriveLimit.WALKS, tuning.personWalks())),
        List.of(new IntParameter(DriveLimit.STYLE, tuning.style().ordinal())),
        List.of(),
        DriveLimit.ALL.stream().map(limit -> new DoubleParameter(limit.name(), limit.of(tuning.limits()))).toList(),
        List.of(new GroupState("Default", true, 0, 0), new GroupState("Limits", true, 1, 0)));
  }

  /** The tuning with what a request names, kept within the bounds; what it does not name stays. */
  static Tuning merge(Tuning now, Config wish) {
    DriveLimits merged = DriveLimit.limits(limit -> number(wish, limit, limit.of(now.limits())));
    int style = wish.ints().stream().filter(each -> each.name().equals(DriveLimit.STYLE)).mapToInt(IntParameter::value)
        .findFirst()
        .orElse(now.style().ordinal());
    boolean walks =
        wish.bools().stream().filter(each -> each.name().equals(DriveLimit.WALKS)).map(BoolParameter::value).findFirst()
            .orElse(now.personWalks());
    return new Tuning(merged, Style.values()[Math.clamp(style, 0, Style.values().length - 1)], walks);
  }

  private static double number(Config wish, DriveLimit limit, double now) {
    OptionalDouble value =
        wish.doubles().stream().filter(each -> each.name().equals(limit.name())).mapToDouble(DoubleParameter::value)
            .filter(Double::isFinite).findFirst();
    return value.isPresent() ? Math.clamp(value.getAsDouble(), limit.lowest(), limit.highest()) : now;
  }
}
