package org.robotui.uic.map.internal;

import java.util.List;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Intake;
import org.robotui.api.port.Port;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;
import org.robotui.data.geometry.Footprint;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.sensor.Bumpers;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.RangeReadings;

/** The ports of the map. */
public final class MapPorts {
  public static final StreamPort<GridMap> MAP =
      new StreamPort<>("map", GridMap.class, Arity.MANY, "Maps; the first is drawn solid, others over it.");
  public static final StreamPort<LaserScan> SCAN =
      new StreamPort<>("scan", LaserScan.class, Arity.MANY, "Laser scans.");
  public static final StreamPort<RangeReadings> SONAR =
      new StreamPort<>("sonar", RangeReadings.class, Arity.MANY, "Distances of sonars and infrared sensors.");
  public static final StreamPort<Bumpers> BUMPER =
      new StreamPort<>("bumper", Bumpers.class, Arity.MANY, "Bumpers, and which are pressed.");
  public static final StreamPort<Odometry> ODOM =
      new StreamPort<>("odom", Odometry.class, Arity.MANY, "Where robots are and have been.");
  public static final StreamPort<Path> PATH = new StreamPort<>("path", Path.class, Arity.MANY, "Planned paths.");
  public static final StreamPort<PoseEstimate> POSE =
      new StreamPort<>("pose", PoseEstimate.class, Arity.MANY, "Where localisation believes robots to be.");
  public static final StreamPort<Footprint> FOOTPRINT =
      new StreamPort<>("footprint", Footprint.class, Arity.MANY, "Outlines of robots.");
  public static final StreamPort<NavigationStatus> NAVIGATION =
      new StreamPort<>("navigation", NavigationStatus.class, Arity.MANY, "What navigation says of goals.");
  public static final CommandPort<NavigationGoal> GOAL =
      new CommandPort<>("goal", NavigationGoal.class, Arity.OPTIONAL, "Where the robot shall go.");
  public static final CommandPort<NavigationGoal> GOALS = new CommandPort<>(
      "goals", NavigationGoal.class, Arity.MANY, "Of several robots: where those that are selected shall go.");
  public static final CommandPort<PoseEstimate> INITIAL_POSE =
      new CommandPort<>("initial_pose", PoseEstimate.class, Arity.OPTIONAL, "Tells localisation where the robot is.");
  public static final CommandPort<PoseEstimate> INITIAL_POSES = new CommandPort<>(
      "initial_poses", PoseEstimate.class, Arity.MANY,
      "Of several robots: tells the localisation of the selected one where it is.");

  public static final StreamPort<Data> DATA =
      new StreamPort<>("data", Data.class, Arity.MANY,
          "Whatever else there are layers for; a robot is asked only for what is shown.", Intake.CHOSEN);

  /** Those that layers are fed from. */
  public static final List<StreamPort<? extends Data>> LAYERS =
      List.of(MAP, SCAN, SONAR, BUMPER, ODOM, PATH, POSE, FOOTPRINT);

  /** All of them. */
  public static final List<Port> ALL =
      List.of(MAP, SCAN, SONAR, BUMPER, ODOM, PATH, POSE, FOOTPRINT, NAVIGATION, DATA, GOAL, GOALS, INITIAL_POSE,
          INITIAL_POSES);

  private MapPorts() {}
}
