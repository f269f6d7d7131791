package org.robotui.sim.internal.message;

import java.util.List;
import java.util.Optional;
import org.robotui.message.ros.diagnostic_msgs.DiagnosticArray;
import org.robotui.message.ros.geometry_msgs.PolygonStamped;
import org.robotui.message.ros.geometry_msgs.PoseWithCovarianceStamped;
import org.robotui.message.ros.nav_msgs.OccupancyGrid;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.message.ros.nav_msgs.Path;
import org.robotui.message.ros.sensor_msgs.BatteryState;
import org.robotui.message.ros.sensor_msgs.Imu;
import org.robotui.message.ros.sensor_msgs.JointState;
import org.robotui.message.ros.sensor_msgs.LaserScan;
import org.robotui.message.ros.sensor_msgs.NavSatFix;
import org.robotui.message.ros.sensor_msgs.Range;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.message.ros.visualization_msgs.MarkerArray;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.Sensors;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.sensor.SonarSpec;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.Pose2;

/** Publishes everything but the camera. What costs work is not even computed while nobody subscribes. */
final class Publications {
  private final MessageNode node;
  private final SimulatedRobot robot;
  private final Simulation simulation;
  private final Sensors measured;
  private final SonarSpec sonars;
  private final Frames frames;
  private final BaseMessages base;
  private final SensorMessages sensors;
  private final DiagnosticMessages diagnostics;
  private final Topic<TFMessage> tf;
  private final Topic<Odometry> odometry;
  private final Topic<LaserScan> scan;
  private final Optional<Topic<Range>> sonar;
  private final Topic<Imu> imu;
  private final Topic<JointState> joints;
  private final Topic<BatteryState> battery;
  private final Topic<PolygonStamped> footprint;
  private final Topic<PoseWithCovarianceStamped> estimate;
  private final Topic<DiagnosticArray> diagnostic;
  private final Topic<Path> plan;
  private final Topic<NavSatFix> fix;
  private final ObjectMarkers objects;
  private final Topic<MarkerArray> objectMarkers;
  private List<Pose2> lastPath = List.of();

  Publications(MessageNode node, SimulatedRobot robot, Frames frames) {
    this.node = node;
    this.robot = robot;
    this.frames = frames;
    simulation = robot.simulation();
    measured = robot.sensors();
    sonars = robot.model().sonars();
    base = new BaseMessages(frames, robot.model());
    sensors = new SensorMessages(frames);
    diagnostics = new DiagnosticMessages(node.name());
    tf = Topic.of(node, "/tf", TFMessage.class, TopicKind.TRANSFORMS);
    odometry = Topic.of(node, "odom", Odometry.class, TopicKind.STATE);
    scan = Topic.of(node, "scan", LaserScan.class, TopicKind.SENSOR);
    sonar =
        sonars.count() == 0 ? Optional.empty() : Optional.of(Topic.of(node, "sonar", Range.class, TopicKind.SENSOR));
    imu = Topic.of(node, "imu/data", Imu.class, TopicKind.SENSOR);
    joints = Topic.of(node, "joint_states", JointState.class, TopicKind.STATE);
    battery = Topic.of(node, "battery_state", BatteryState.class, TopicKind.SELDOM);
    footprint = Topic.of(node, "footprint", PolygonStamped.class, TopicKind.STATE);
    estimate = Topic.of(node, "amcl_pose", PoseWithCovarianceStamped.class, TopicKind.LATCHED);
    diagnostic = Topic.of(node, "/diagnostics", DiagnosticArray.class, TopicKind.STATE);
    plan = Topic.of(node, "plan", Path.class, TopicKind.SELDOM);
    fix = Topic.of(node, "fix", NavSatFix.class, TopicKind.STATE);
    objects = new ObjectMarkers(simulation.world());
    objectMarkers = Topic.of(node, "objects", MarkerArray.class, TopicKind.STATE);
  }

  /** What the robot is made of. */
  String description() {
    return Description.of(frames, robot.model(), new StaticTransforms(frames).message(robot.model(), new Stamp(0, 0)));
  }

  /** Publishes what never changes. */
  void publishOnce(GridMap map, long nanos) {
    Topic.of(node, "map", OccupancyGrid.class, TopicKind.LATCHED).publish(nanos, stamp -> sensors.map(map, stamp));
    Topic.of(node, "/tf_static", TFMessage.class, TopicKind.LATCHED).publish(
        nanos, stamp -> new StaticTransforms(frames).message(robot.model(), stamp));
    plan.publish(nanos, stamp -> base.path(List.of(), stamp));
  }

  /** Publishes what is due with a step. */
  void publish(long step, RobotState state, long nanos) {
    if (Rate.TRANSFORMS.isDue(step)) {
      tf.publish(nanos, stamp -> base.transforms(state, stamp));
    }
    if (Rate.ODOMETRY.isDue(step)) {
      odometry.publish(nanos, stamp -> base.odometry(state, stamp));
    }
    if (Rate.IMU.isDue(step)) {
      imu.publish(nanos, stamp -> base.imu(simulation.imu(), stamp));
    }
    publishScan(step, nanos);
    sonar.filter(Topic::isWanted).ifPresent(topic -> publishSonars(topic, step, nanos));
    publishPlan(step, state, nanos);
    publishSlow(step, state, nanos);
  }

  private void publishScan(long step, long nanos) {
    if (measured.isScanDue(step)) {
      scan.publish(nanos, stamp -> sensors.scan(simulation.settings().laser(), measured.scan(step), stamp));
    }
  }

  /** The sensors fire one after the other, as they must not hear each other. */
  private void publishSonars(Topic<Range> topic, long step, long nanos) {
    for (int i = 0; i < sonars.count(); i++) {
      if (Rate.SONAR.isDue(step + i)) {
        int index = i;
        topic.publish(nanos, stamp -> sensors.sonar(sonars, index, measured.sonar(index), stamp));
      }
    }
  }

  /** Also without a path, so that who comes late and is not sent the last one knows that there is none. */
  private void publishPlan(long step, RobotState state, long nanos) {
    if (Rate.PLAN.isDue(step) || !state.path().equals(lastPath)) {
      lastPath = state.path();
      plan.publish(nanos, stamp -> base.path(state.path(), stamp));
    }
  }

  private void publishSlow(long step, RobotState state, long nanos) {
    if (Rate.JOINTS.isDue(step)) {
      joints.publish(nanos, stamp -> base.joints(state, stamp));
    }
    if (Rate.FOOTPRINT.isDue(step)) {
      footprint.publish(nanos, stamp -> base.footprint(state, stamp));
    }
    if (Rate.ESTIMATE.isDue(step)) {
      estimate.publish(nanos, stamp -> base.estimate(state, stamp));
    }
    if (Rate.FIX.isDue(step)) {
      fix.publish(nanos, stamp -> sensors.fix(measured.fix(), stamp));
    }
    if (Rate.OBJECTS.isDue(step)) {
      objectMarkers.publish(nanos, stamp -> objects.message(state, stamp));
    }
    if (Rate.BATTERY.isDue(step)) {
      battery.publish(nanos, stamp -> base.battery(state, stamp));
    }
    if (Rate.DIAGNOSTICS.isDue(step)) {
      diagnostic.publish(nanos, stamp -> diagnostics.all(state, simulation.settings().laser().frequency(), stamp));
    }
  }
}
