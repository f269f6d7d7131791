package org.robotui.sim.internal.ros;

import java.util.List;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.message.MessageCodec;
import org.robotui.ros.msgs.actionlib_msgs.GoalStatusArray;
import org.robotui.ros.msgs.diagnostic_msgs.DiagnosticArray;
import org.robotui.ros.msgs.geometry_msgs.PolygonStamped;
import org.robotui.ros.msgs.geometry_msgs.PoseWithCovarianceStamped;
import org.robotui.ros.msgs.nav_msgs.OccupancyGrid;
import org.robotui.ros.msgs.nav_msgs.Odometry;
import org.robotui.ros.msgs.nav_msgs.Path;
import org.robotui.ros.msgs.sensor_msgs.BatteryState;
import org.robotui.ros.msgs.sensor_msgs.Imu;
import org.robotui.ros.msgs.sensor_msgs.JointState;
import org.robotui.ros.msgs.sensor_msgs.LaserScan;
import org.robotui.ros.msgs.sensor_msgs.Range;
import org.robotui.ros.msgs.tf2_msgs.TFMessage;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.camera.Lens;
import org.robotui.sim.internal.sensor.LaserScanner;
import org.robotui.sim.internal.sensor.SonarRing;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.Pose2;

/** Publishes everything but the camera. What costs work is not even computed while nobody subscribes. */
final class Publications {
  private static final int QUEUE = 50;

  private final RosNode node;
  private final Simulation simulation;
  private final LaserScanner laser;
  private final SonarRing sonars;
  private final BaseMessages base;
  private final SensorMessages sensors;
  private final DiagnosticMessages diagnostics;
  private final Publisher<TFMessage> tf;
  private final Publisher<Odometry> odometry;
  private final Publisher<LaserScan> scan;
  private final Publisher<Range> sonar;
  private final Publisher<Imu> imu;
  private final Publisher<JointState> joints;
  private final Publisher<BatteryState> battery;
  private final Publisher<PolygonStamped> footprint;
  private final Publisher<PoseWithCovarianceStamped> estimate;
  private final Publisher<DiagnosticArray> diagnostic;
  private final Publisher<Path> plan;
  private final Publisher<GoalStatusArray> goalStatus;
  private List<Pose2> lastPath = List.of();

  Publications(RosNode node, Simulation simulation, Frames frames) {
    this.node = node;
    this.simulation = simulation;
    laser = new LaserScanner(simulation.world(), simulation.settings().laser(), simulation.random(10));
    sonars = new SonarRing(simulation.world(), simulation.random(11));
    base = new BaseMessages(frames);
    sensors = new SensorMessages(frames);
    diagnostics = new DiagnosticMessages(node.name().text().substring(1));
    tf = topic("/tf", TFMessage.CODEC);
    odometry = topic("odom", Odometry.CODEC);
    scan = topic("scan", LaserScan.CODEC);
    sonar = topic("sonar", Range.CODEC);
    imu = topic("imu/data", Imu.CODEC);
    joints = topic("joint_states", JointState.CODEC);
    battery = latched("battery_state", BatteryState.CODEC);
    footprint = topic("footprint", PolygonStamped.CODEC);
    estimate = latched("amcl_pose", PoseWithCovarianceStamped.CODEC);
    diagnostic = topic("/diagnostics", DiagnosticArray.CODEC);
    plan = latched("plan", Path.CODEC);
    goalStatus = topic("move_base/status", GoalStatusArray.CODEC);
  }

  private <T> Publisher<T> topic(String name, MessageCodec<T> codec) {
    return node.publisher(name, codec, PublisherOptions.standard().withQueue(QUEUE));
  }

  private <T> Publisher<T> latched(String name, MessageCodec<T> codec) {
    return node.publisher(name, codec, PublisherOptions.latched().withQueue(QUEUE));
  }

  /** Publishes what never changes. */
  void publishOnce(GridMap map, Lens lens, Frames frames, long stamp) {
    latched("map", OccupancyGrid.CODEC).publish(sensors.map(map, stamp));
    latched("/tf_static", TFMessage.CODEC).publish(
        new StaticTransforms(frames).message(laser.spec(), lens, sonars, stamp));
    plan.publish(base.path(List.of(), stamp));
  }

  /** Publishes what is due with a step. */
  void publish(long step, RobotState state, long stamp) {
    if (Rate.TRANSFORMS.isDue(step)) {
      tf.publish(base.transforms(state, stamp));
    }
    if (Rate.ODOMETRY.isDue(step)) {
      odometry.publish(base.odometry(state, stamp));
    }
    if (Rate.IMU.isDue(step)) {
      imu.publish(base.imu(simulation.imu(), stamp));
    }
    publishScan(step, state, stamp);
    publishSonars(step, state, stamp);
    publishPlan(step, state, stamp);
    publishSlow(step, state, stamp);
  }

  private void publishScan(long step, RobotState state, long stamp) {
    if (Rate.SCAN.isDue(step) && scan.numSubscribers() > 0) {
      scan.publish(sensors.scan(laser.spec(), laser.scan(state.truth()), 1 / Rate.SCAN.hertz(), stamp));
    }
  }

  /** The sensors fire one after the other, as they must not hear each other. */
  private void publishSonars(long step, RobotState state, long stamp) {
    if (sonar.numSubscribers() == 0) {
      return;
    }
    for (int i = 0; i < sonars.count(); i++) {
      if (Rate.SONAR.isDue(step + i)) {
        sonar.publish(sensors.sonar(i, sonars.measure(state.truth(), i), stamp));
      }
    }
  }

  private void publishPlan(long step, RobotState state, long stamp) {
    boolean changed = !state.path().equals(lastPath);
    boolean driving = !state.path().isEmpty() && Rate.PLAN.isDue(step);
    if (changed || driving) {
      lastPath = state.path();
      plan.publish(base.path(lastPath, stamp));
    }
  }

  private void publishSlow(long step, RobotState state, long stamp) {
    if (Rate.JOINTS.isDue(step)) {
      joints.publish(base.joints(state, stamp));
    }
    if (Rate.FOOTPRINT.isDue(step)) {
      footprint.publish(base.footprint(state, stamp));
    }
    if (Rate.ESTIMATE.isDue(step)) {
      estimate.publish(base.estimate(state, stamp));
      goalStatus.publish(base.goalStatus(state, stamp));
    }
    if (Rate.BATTERY.isDue(step)) {
      battery.publish(base.battery(state, stamp));
    }
    if (Rate.DIAGNOSTICS.isDue(step)) {
      diagnostic.publish(diagnostics.all(state, Rate.SCAN.hertz(), stamp));
    }
  }
}
