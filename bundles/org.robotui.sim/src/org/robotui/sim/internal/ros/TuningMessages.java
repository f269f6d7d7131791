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
import org.robotui.sim.internal.robot.DriveLimits;

/** The robot's tuning as messages of dynamic_reconfigure. */
final class TuningMessages {
  private static final String LINEAR = "max_linear_speed";
  private static final String ANGULAR = "max_angular_speed";
  private static final String LINEAR_ACCELERATION = "max_linear_acceleration";
  private static final String ANGULAR_ACCELERATION = "max_angular_acceleration";
  private static final String STYLE = "driving_style";
  private static final String WALKS = "person_walks";
  private static final DriveLimits LOWEST = new DriveLimits(0.05, 0.1, 0.1, 0.5);
  private static final DriveLimits HIGHEST = new DriveLimits(1.5, 4.0, 3.0, 12.0);

  private TuningMessages() {}

  static ConfigDescription description(Tuning initial) {
    Group all = new Group("Default", "", List.of(
        parameter(STYLE, "int", "How it drives to goals", styles()),
        parameter(WALKS, "bool", "Whether the person in the building walks", "")), 0, 0);
    Group limits = new Group("Limits", "collapse", List.of(
        parameter(LINEAR, "double", "Metres per second", ""),
        parameter(ANGULAR, "double", "Radians per second", ""),
        parameter(LINEAR_ACCELERATION, "double", "Metres per second squared; it brakes twice as hard", ""),
        parameter(ANGULAR_ACCELERATION, "double", "Radians per second squared; it brakes twice as hard", "")), 0, 1);
    Style[] styles = Style.values();
    return new ConfigDescription(
        List.of(all, limits),
        config(new Tuning(HIGHEST, styles[styles.length - 1], true)),
        config(new Tuning(LOWEST, styles[0], false)),
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
        .collect(Collectors.joining(", ", "{'enum': [", "], 'enum_description': 'How it drives to goals'}"));
  }

  private static String title(Style style) {
    return style.name().charAt(0) + style.name().substring(1).toLowerCase(Locale.ROOT);
  }

  static Config config(Tuning tuning) {
    DriveLimits limits = tuning.limits();
    return new Config(
        List.of(new BoolParameter(WALKS, tuning.personWalks())),
        List.of(new IntParameter(STYLE, tuning.style().ordinal())),
        List.of(),
        List.of(
            new DoubleParameter(LINEAR, limits.linear()),
            new DoubleParameter(ANGULAR, limits.angular()),
            new DoubleParameter(LINEAR_ACCELERATION, limits.linearAcceleration()),
            new DoubleParameter(ANGULAR_ACCELERATION, limits.angularAcceleration())),
        List.of(new GroupState("Default", true, 0, 0), new GroupState("Limits", true, 1, 0)));
  }

  /** The tuning with what a request names, kept within the bounds; what it does not name stays. */
  static Tuning merge(Tuning now, Config wish) {
    DriveLimits limits = now.limits();
    DriveLimits merged = new DriveLimits(
        number(wish, LINEAR, limits.linear(), LOWEST.linear(), HIGHEST.linear()),
        number(wish, ANGULAR, limits.angular(), LOWEST.angular(), HIGHEST.angular()),
        number(wish, LINEAR_ACCELERATION, limits.linearAcceleration(), LOWEST.linearAcceleration(),
            HIGHEST.linearAcceleration()),
        number(wish, ANGULAR_ACCELERATION, limits.angularAcceleration(), LOWEST.angularAcceleration(),
            HIGHEST.angularAcceleration()));
    int style = wish.ints().stream().filter(each -> each.name().equals(STYLE)).mapToInt(IntParameter::value).findFirst()
        .orElse(now.style().ordinal());
    boolean walks =
        wish.bools().stream().filter(each -> each.name().equals(WALKS)).map(BoolParameter::value).findFirst()
            .orElse(now.personWalks());
    return new Tuning(merged, Style.values()[Math.clamp(style, 0, Style.values().length - 1)], walks);
  }

  private static double number(Config wish, String name, double now, double lowest, double highest) {
    OptionalDouble value =
        wish.doubles().stream().filter(each -> each.name().equals(name)).mapToDouble(DoubleParameter::value)
            .filter(Double::isFinite).findFirst();
    return value.isPresent() ? Math.clamp(value.getAsDouble(), lowest, highest) : now;
  }
}
