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
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows robots as they look. */
@Component(service = DisplayType.class)
public final class RobotModelType implements DisplayType {
  static final String VISUAL = "visual";
  static final String COLLISION = "collision";
  static final String INERTIA = "inertia";
  static final String OPACITY = "opacity";
  static final String COLOR = "color";
  static final String POSES = "poses";
  static final String NAMES = "names";
  static final String AXES = "axes";
  static final String GROUP = "group";
  static final String TF_PREFIX = "tf_prefix";
  static final String PACKAGES = "packages";

  private static final ValueType FLAG = new ValueType.Flag();
  private static final ValueType TEXT = new ValueType.Text();
  static final Schema SCHEMA = Schema.of(
      Setting.of(VISUAL, FLAG, true, "Whether links are shown as they look."),
      Setting.of(COLLISION, FLAG, false, "Whether the forms are shown with which collisions are computed."),
      Setting.of(INERTIA, FLAG, false, "Whether boxes are shown that have the mass and the moments of the links."),
      Setting.of(OPACITY, new ValueType.Num(0, 1, ""), 1.0, "0 invisible to 1 as the model says."),
      Setting.of(COLOR, new ValueType.Choice(List.of("own", "robot")), "own",
          "Whether links have their own colours, or all that of the robot."),
      Setting.of(POSES, new ValueType.Choice(List.of("auto", "tf", "joints")), "auto",
          "What moves the links: transforms, or joint states on the model's root; auto takes joint states where there are some."),
      Setting.of(NAMES, FLAG, false, "Whether the names of the links are written at them."),
      Setting.of(AXES, FLAG, false, "Whether the frames of the links are shown."),
      Setting.of(GROUP, TEXT, "", "A group of the robot's SRDF whose links are marked; empty for none."),
      Setting.of(TF_PREFIX, TEXT, "", "What stands before the names of links in the names of their frames."),
      Setting.of(PACKAGES, new ValueType.ListOf(TEXT), List.of(),
          "Folders that are packages or contain packages, for meshes; before those of ROS_PACKAGE_PATH."));

  private final ModelShelf shelf;

  /**
   * Shows models.
   *
   * @param shelf where models are that other displays hold
   */
  @Activate
  public RobotModelType(@Reference ModelShelf shelf) {
    this.shelf = shelf;
  }

  @Override
  public String id() {
    return "robotmodel";
  }

  @Override
  public String label() {
    return "Robot model";
  }

  @Override
  public String help() {
    return "Shows a robot as its URDF describes it, where its transforms or joint states say.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(RobotDescription.class, JointState.class);
  }

  @Override
  public Set<Class<? extends Data>> needs() {
    return Set.of(RobotDescription.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new RobotModelDisplay(context, shelf);
  }
}
