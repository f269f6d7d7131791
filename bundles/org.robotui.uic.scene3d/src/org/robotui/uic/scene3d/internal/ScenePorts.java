package org.robotui.uic.scene3d.internal;

import java.util.List;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Intake;
import org.robotui.api.port.Port;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.marker.MarkerFeedback;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;

/** The ports of the scene. */
public final class ScenePorts {
  public static final StreamPort<Data> DATA = new StreamPort<>(
      "data", Data.class, Arity.MANY, "whatever displays show; a robot is asked only for what is shown", Intake.CHOSEN);
  public static final CommandPort<NavigationGoal> GOAL =
      new CommandPort<>("goal", NavigationGoal.class, Arity.OPTIONAL, "Where the robot shall go.");
  public static final CommandPort<PoseEstimate> INITIAL_POSE =
      new CommandPort<>("initial_pose", PoseEstimate.class, Arity.OPTIONAL, "Tells localisation where the robot is.");
  public static final CommandPort<MarkerFeedback> MARKERS =
      new CommandPort<>("marker_feedback", MarkerFeedback.class, Arity.OPTIONAL,
          "What the user does with interactive markers.");

  public static final CommandPort<Path> PATH =
      new CommandPort<>("path", Path.class, Arity.OPTIONAL, "The waypoints of the scene, as a path.");
  public static final CommandPort<PoseArray> POSES =
      new CommandPort<>("poses", PoseArray.class, Arity.OPTIONAL, "The waypoints of the scene, as poses.");

  /** All of them. */
  public static final List<Port> ALL = List.of(DATA, GOAL, INITIAL_POSE, MARKERS, PATH, POSES);

  private ScenePorts() {}
}
