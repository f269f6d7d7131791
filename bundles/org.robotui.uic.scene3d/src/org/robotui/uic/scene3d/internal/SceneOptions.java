package org.robotui.uic.scene3d.internal;

import java.util.List;
import java.util.Map;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.ui.display.DisplayEntry;
import org.robotui.ui.display.DisplayKind;
import org.robotui.uic.scene3d.internal.camera.CameraKind;

/** The settings of the scene. */
public final class SceneOptions {
  public static final String DISPLAYS = "displays";
  public static final String AUTOMATIC = DisplayEntry.AUTOMATIC;
  public static final String FIXED_FRAME = "fixed_frame";
  public static final String AUTO = "auto";
  public static final String FRAMES = "frames";
  public static final String COLORS = "robot_colors";
  public static final String FOLLOW = "follow";
  public static final String FOLLOW_YAW = "follow_yaw";
  public static final String VIEWS = "views";
  public static final String CAMERA = "camera";
  public static final String TREE = "tree";
  public static final String THINNING = "thinning";
  public static final String WAYPOINTS = "waypoints";
  public static final String WAYPOINT_FRAME = "waypoint_frame";
  public static final String WAYPOINT_SIZE = "waypoint_size";
  public static final String WAYPOINT_TOLERANCE = "waypoint_tolerance";

  public static final String TYPE = "type";
  public static final String PARENT = "parent";
  public static final String CHILD = "child";
  public static final String KIND = "kind";

  private static final double FAR = 1e9;
  private static final ValueType NUMBER = new ValueType.Num(-FAR, FAR, "m");
  private static final ValueType ANGLE = new ValueType.Num(-FAR, FAR, "rad");
  private static final TextRule ROBOT_FRAME = TextRule.matching("a frame of a robot, such as Natalie/map", "[^/]+/.+");
  private static final TextRule ROBOT_COLOR = TextRule.matching("a colour, such as \"#4da3ff\"", "#[0-9a-fA-F]{6}");
  private static final ValueType FRAME_OR_NONE = new ValueType.Text(TextRule.FRAME.orEmpty("\"\""));

  private static final Schema FRAME = Schema.of(
      Setting.required(PARENT, new ValueType.Text(ROBOT_FRAME), "A frame as robot/frame, for example a/map."),
      Setting.required(CHILD, new ValueType.Text(ROBOT_FRAME), "A frame of another robot, for example b/map."),
      Setting.of("x", NUMBER, 0.0, "Place of the child in the parent."),
      Setting.of("y", NUMBER, 0.0, "Place of the child in the parent."),
      Setting.of("z", NUMBER, 0.0, "Place of the child in the parent."),
      Setting.of("roll", ANGLE, 0.0, "Turn of the child about x."),
      Setting.of("pitch", ANGLE, 0.0, "Turn of the child about y."),
      Setting.of("yaw", ANGLE, 0.0, "Turn of the child about z."));

  private static final Schema WAYPOINT = Schema.of(
      Setting.of("x", NUMBER, 0.0, "Where it is in the frame of the waypoints."),
      Setting.of("y", NUMBER, 0.0, "Where it is in the frame of the waypoints."),
      Setting.of("z", NUMBER, 0.0, "Where it is in the frame of the waypoints."),
      Setting.of("yaw", ANGLE, 0.0, "Where the robot looks."));

  private static final List<Setting> POSE = List.of(
      Setting.of(KIND,
          new ValueType.Choice(List.of(CameraKind.ORBIT.word(), CameraKind.FLY.word(), CameraKind.TOP.word())),
          CameraKind.ORBIT.word(), "How it is moved."),
      Setting.of("x", NUMBER, 0.0, "What it looks at."),
      Setting.of("y", NUMBER, 0.0, "What it looks at."),
      Setting.of("z", NUMBER, 0.0, "What it looks at."),
      Setting.of("distance", NUMBER, 10.0, "From there to the eye."),
      Setting.of("yaw", ANGLE, 0.0, "Where it looks."),
      Setting.of("pitch", ANGLE, 0.6, "Angle below the horizon, down is positive."));

  private static final Schema SCHEMA = Schema.of(
      Setting.of(DISPLAYS, DisplayEntry.list("display", "laserscan"), List.of(),
          "What is shown, in the order of the list; without, what the robot offers."),
      Setting.of(AUTOMATIC, new ValueType.Flag(), true, "Show what the robot offers while no displays are listed."),
      Setting.of(FIXED_FRAME, new ValueType.Text(TextRule.FRAME), AUTO,
          "The fixed frame; auto takes map, else odom, else the first root."),
      Setting.of(FRAMES, new ValueType.ListOf(new ValueType.Section(FRAME)), List.of(),
          "Transforms between the frames of robots that no robot publishes."),
      Setting.of(COLORS, new ValueType.MapOf(new ValueType.Text(ROBOT_COLOR)), Map.of(),
          "Colours of robots by name, as #4da3ff."),
      Setting.of(VIEWS, new ValueType.MapOf(new ValueType.Section(new Schema(POSE))), Map.of(),
          "Views by name; the one that is named start is where the scene begins."),
      Setting.optional(CAMERA, new ValueType.Section(new Schema(POSE)),
          "Where the user left the camera; the scene begins there unless a view is named start.")
          .asState(),
      Setting.of(FOLLOW, FRAME_OR_NONE, "", "The frame that the camera keeps up with; empty for none."),
      Setting.of(FOLLOW_YAW, new ValueType.Flag(), false, "Whether the camera also turns with it."),
      Setting.of(WAYPOINTS, new ValueType.ListOf(new ValueType.Section(WAYPOINT)), List.of(),
          "Poses to drive to, one after the other."),
      Setting.of(WAYPOINT_FRAME, FRAME_OR_NONE, "",
          "The frame of the waypoints as robot/frame; empty for the fixed frame."),
      Setting.of(WAYPOINT_SIZE, new ValueType.Num(0.02, 100, "m"), 0.4, "How large waypoints are drawn."),
      Setting.of(WAYPOINT_TOLERANCE, new ValueType.Num(0.01, 100, "m"), 0.3,
          "How near the robot must come before it is sent to the next waypoint."),
      Setting.of(THINNING, new ValueType.Flag(), true,
          "Whether clouds are thinned while the camera moves, so that it moves fluidly."),
      Setting.of(TREE, new ValueType.Flag(), true, "Whether the list of displays is seen."));

  private SceneOptions() {}

  /** The same with kinds of displays to choose from. */
  static Schema schema(List<DisplayKind> kinds) {
    Setting listed = SCHEMA.find(DISPLAYS).orElseThrow();
    Setting offering = Setting.of(DISPLAYS, DisplayEntry.list("display", "laserscan", kinds), List.of(), listed.help());
    return new Schema(SCHEMA.settings().stream().map(s -> s == listed ? offering : s).toList());
  }

  /** What a scene can be configured with. */
  public static Schema schema() {
    return SCHEMA;
  }
}
