package org.robotui.api.session;

import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;

/**
 * How the frames are called that carry all others of a mobile robot (REP-105), for frameworks that name none.
 *
 * @param base the frame of the robot's base
 * @param odom the frame of its odometry
 * @param map the frame of maps, plans and localisation
 */
public record BaseFrames(String base, String odom, String map) {
  private static final ValueType FRAME = new ValueType.Text(TextRule.FRAME);

  /** The setting of the frame of the base, {@code base_link} unless it is written. */
  public static final Setting BASE =
      Setting.of("base_frame", FRAME, "base_link", "name of the frame of the robot's base");
  /** The setting of the frame of the odometry, {@code odom} unless it is written. */
  public static final Setting ODOM = Setting.of("odom_frame", FRAME, "odom", "name of the frame of its odometry");
  /** The setting of the frame of maps, {@code map} unless it is written. */
  public static final Setting MAP =
      Setting.of("map_frame", FRAME, "map", "name of the frame of maps, plans and localisation");

  /**
   * Reads them from settings whose schema has all three.
   *
   * @param settings checked
   * @return the names
   */
  public static BaseFrames of(Settings settings) {
    return new BaseFrames(settings.text(BASE.name()), settings.text(ODOM.name()), settings.text(MAP.name()));
  }

  /**
   * The frames of one robot.
   *
   * @param robot its name
   * @return with these names
   */
  public RobotFrames of(String robot) {
    return new RobotFrames(robot, this);
  }
}
