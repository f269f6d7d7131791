package org.robotui.uic.plot.internal.model;

import java.util.List;
import java.util.function.Function;
import java.util.regex.Pattern;
import org.robotui.uic.plot.internal.signal.Expr;

/**
 * The units of the fields of data records and of the robot messages whose definition gives them; and of what is
 * computed.
 */
public final class Units {
  private static final String METRE = "m";
  private static final String RADIAN = "rad";
  private static final String SECOND = "s";
  private static final String PER_SECOND = "/s";
  private static final String SQUARED = "\u00b2";

  private static final List<Rule> RULES = List.of(
      rule(".*(Accel|Imu).*", "(.*\\.)?(acceleration|linear_?[aA]cceleration|linear)(\\.[xyz])?", "m/s\u00b2"),
      rule(".*(Odometry|Twist|VelocityCommand|Motion|Velocity).*", "(.*\\.)?linear(\\.[xyz])?", "m/s"),
      rule(".*", "(.*\\.)?(angular|angularVelocity|angular_velocity)(\\.[xyz])?", "rad/s"),
      rule("turtlesim/Pose", "linear_velocity", "m/s"),
      rule("turtlesim/Pose", "theta", RADIAN),
      rule("turtlesim/Pose", "[xy]", METRE),
      rule(".*Point(Stamped)?|.*Vector3", "(.*\\.)?[xyz]", METRE),
      rule(".*", "(.*\\.)?(translation|position)\\.[xyz]", METRE),
      rule(".*(LaserScan|Range).*", "(ranges?(\\[\\d+])?|(ranges|readings)\\[\\d+]\\.range|range_?(min|max))", METRE),
      rule(".*LaserScan", "angle_?(min|max|increment)|angleMin|angleIncrement", RADIAN),
      rule(".*LaserScan", "(scan_?[tT]ime|time_increment)", SECOND),
      rule("(Battery|.*BatteryState)", "voltage", "V"),
      rule("(Battery|.*BatteryState)", "current", "A"),
      rule("GpsFix", "latitude|longitude", RADIAN),
      rule(".*NavSatFix", "latitude|longitude", "\u00b0"),
      rule("GpsFix|.*NavSatFix", "altitude", METRE),
      rule(".*Temperature", "temperature", "\u00b0C"));

  private Units() {}

  private record Rule(Pattern schema, Pattern path, String unit) {}

  /** The unit of a field; empty where none is known. */
  public static String of(String schema, String path) {
    return RULES.stream().filter(r -> r.schema.matcher(schema).matches() && r.path.matcher(path).matches())
        .map(Rule::unit).findFirst().orElse("");
  }

  /** The unit of a signal, from those of its fields; empty where none is known. */
  public static String of(Expr expr, Function<Expr.Field, String> known) {
    return switch (expr) {
      case Expr.Field f -> known.apply(f);
      case Expr.Derivative d -> perSecond(of(d.of(), known));
      case Expr.Integral i -> timesSecond(of(i.of(), known));
      case Expr.Average a -> of(a.of(), known);
      case Expr.Scale s -> s.factor() == 1 ? of(s.of(), known) : "";
      case Expr.Difference d -> common(List.of(d.of(), d.less()), known);
      case Expr.Over o -> of(o.of(), known);
      case Expr.Norm n -> common(n.of(), known);
    };
  }

  private static String common(List<Expr> of, Function<Expr.Field, String> known) {
    List<String> units = of.stream().map(e -> of(e, known)).distinct().toList();
    return units.size() == 1 ? units.getFirst() : "";
  }

  private static String perSecond(String unit) {
    if (unit.endsWith(PER_SECOND)) {
      return unit + SQUARED;
    }
    if (unit.equals(SECOND)) {
      return "";
    }
    return unit.isEmpty() || unit.endsWith(SQUARED) ? "" : unit + PER_SECOND;
  }

  private static String timesSecond(String unit) {
    if (unit.endsWith(PER_SECOND + SQUARED)) {
      return unit.substring(0, unit.length() - 1);
    }
    if (unit.endsWith(PER_SECOND)) {
      return unit.substring(0, unit.length() - PER_SECOND.length());
    }
    return unit.isEmpty() ? "" : unit + "\u00b7s";
  }

  private static Rule rule(String schema, String path, String unit) {
    return new Rule(Pattern.compile(schema), Pattern.compile(path), unit);
  }
}
