package org.robotui.data.record;

import java.util.List;
import java.util.regex.Pattern;

/** The units of the fields of data records, and of the robot messages whose definition gives them. */
public final class FieldUnits {
  private static final String METRE = "m";
  private static final String RADIAN = "rad";
  private static final String SECOND = "s";

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

  private FieldUnits() {}

  private record Rule(Pattern schema, Pattern path, String unit) {}

  /**
   * The unit of a field.
   *
   * @param schema what its record is called
   * @param path of the field
   * @return empty where none is known
   */
  public static String of(String schema, String path) {
    return RULES.stream().filter(r -> r.schema.matcher(schema).matches() && r.path.matcher(path).matches())
        .map(Rule::unit).findFirst().orElse("");
  }

  private static Rule rule(String schema, String path, String unit) {
    return new Rule(Pattern.compile(schema), Pattern.compile(path), unit);
  }
}
