package org.robotui.entity.robotmodel.internal;

import java.util.List;
import java.util.Set;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.RobotDescription;
import org.robotui.data.joint.Trajectory;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows how a robot is planned to move, against how it moved. */
@Component(service = DisplayType.class)
public final class TrajectoryType implements DisplayType {
  static final String REPEAT = "repeat";
  static final String SPEED = "speed";
  static final String OPACITY = "opacity";
  static final String COLOR = "color";
  static final String TRAIL = "trail";
  static final String LINK = "link";
  static final String PATH = "path";
  static final String EXECUTED = "executed";
  static final String EXECUTED_COLOR = "executed_color";
  static final String WIDTH = "width";
  static final String TIMEOUT = "timeout";

  private static final ValueType FLAG = new ValueType.Flag();
  private static final ValueType TEXT = new ValueType.Text();
  static final Schema SCHEMA = Schema.of(
      Setting.of(REPEAT, new ValueType.Choice(List.of("loop", "once", "end")), "loop",
          "How the ghost moves: again and again, once, or not at all but standing at the end."),
      Setting.of(SPEED, new ValueType.Num(0.01, 100, ""), 1.0, "How many times faster than planned."),
      Setting.of(OPACITY, new ValueType.Num(0, 1, ""), 0.4, "Of the ghost, 0 invisible to 1 opaque."),
      ColorSetting.of(COLOR, "#f5b83d", "The colour of what is planned."),
      Setting.of(TRAIL, new ValueType.Int(0, 10_000), 0L,
          "A paler figure at every n-th point of the trajectory; 0 for none."),
      Setting.of(LINK, TEXT, "",
          "The link whose path is drawn; empty for the tip, which most of the planned joints move."),
      Setting.of(PATH, FLAG, true, "Whether the planned path of the link is drawn."),
      Setting.of(EXECUTED, FLAG, true, "Whether the path is drawn that the link has travelled since the plan came."),
      ColorSetting.of(EXECUTED_COLOR, "#3ecf8e", "The colour of what was executed."),
      Setting.of(WIDTH, new ValueType.Num(0.5, 50, "px"), 3.0, "Width of the lines."),
      Setting.of(TIMEOUT, new ValueType.Num(0, 86_400, "s"), 0.0,
          "How long a trajectory is shown; 0 until the next one."),
      Setting.of(RobotModelType.TF_PREFIX, TEXT, "",
          "What stands before the names of links in the names of their frames."),
      Setting.of(RobotModelType.PACKAGES, new ValueType.ListOf(TEXT), List.of(),
          "Folders that are packages or contain packages, for meshes; before those of ROS_PACKAGE_PATH."));

  private final ModelShelf shelf;

  /**
   * Shows trajectories.
   *
   * @param shelf where models are that other displays hold
   */
  @Activate
  public TrajectoryType(@Reference ModelShelf shelf) {
    this.shelf = shelf;
  }

  @Override
  public String id() {
    return "trajectory";
  }

  @Override
  public String label() {
    return "Trajectory";
  }

  @Override
  public String help() {
    return "Shows a planned motion as a ghost of the robot, and what was executed against it.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(Trajectory.class, RobotDescription.class, JointState.class);
  }

  @Override
  public Set<Class<? extends Data>> needs() {
    return Set.of(Trajectory.class, RobotDescription.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new TrajectoryDisplay(context, shelf);
  }
}
