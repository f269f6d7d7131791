package org.robotui.sim.internal.message;

import java.util.ArrayList;
import java.util.List;
import org.robotui.geometry.RigidTransform;
import org.robotui.message.ros.geometry_msgs.Point32;
import org.robotui.message.ros.geometry_msgs.Polygon;
import org.robotui.message.ros.geometry_msgs.PolygonStamped;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.geometry_msgs.PoseWithCovariance;
import org.robotui.message.ros.geometry_msgs.PoseWithCovarianceStamped;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.TwistWithCovariance;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.message.ros.nav_msgs.Path;
import org.robotui.message.ros.sensor_msgs.BatteryState;
import org.robotui.message.ros.sensor_msgs.Imu;
import org.robotui.message.ros.sensor_msgs.JointState;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.model.RobotModel;
import org.robotui.sim.internal.robot.Battery;
import org.robotui.sim.internal.robot.Head;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Pose2;

/** Messages about the base: where it is, how it moves, what it has left. */
final class BaseMessages {
  private static final int FOOTPRINT_CORNERS = 16;

  private final Frames frames;
  private final RobotModel robot;

  BaseMessages(Frames frames, RobotModel robot) {
    this.frames = frames;
    this.robot = robot;
  }

  Odometry odometry(RobotState state, Stamp stamp) {
    PoseWithCovariance pose = new PoseWithCovariance(Poses.pose(state.odometry()), planar(0.01, 0.02));
    Speed speed = state.speed();
    Twist twist = new Twist(new Vector3(speed.linear(), 0, 0), new Vector3(0, 0, speed.angular()));
    return new Odometry(
        stamp.header(frames.odometry()), frames.base(), pose,
        new TwistWithCovariance(twist, planar(0.001, 0.003)));
  }

  /** A 6 x 6 covariance of x, y and yaw; what the plane does not have is certain. */
  private static double[] planar(double position, double heading) {
    double[] covariance = new double[36];
    covariance[0] = position;
    covariance[7] = position;
    covariance[35] = heading;
    return covariance;
  }

  /**
   * The moving edges of the tree: the map to odometry, odometry to the base, and the base to the head and to the
   * wheels.
   */
  TFMessage transforms(RobotState state, Stamp stamp) {
    Header map = stamp.header(Frames.MAP);
    Header odometry = stamp.header(frames.odometry());
    List<TransformStamped> all = new ArrayList<>();
    all.add(Poses.stamped(map, frames.odometry(), Poses.transform(state.mapFromOdometry(), 0)));
    all.add(Poses.stamped(odometry, frames.base(), Poses.transform(state.odometry(), 0)));
    state.head().ifPresent(head -> {
      all.add(Poses.stamped(stamp.header(frames.base()), frames.pan(), turned(Head.HEIGHT, 0, head.pan())));
      all.add(Poses.stamped(stamp.header(frames.pan()), frames.tilt(), turned(Head.NECK, head.tilt(), 0)));
    });
    all.add(Poses.stamped(stamp.header(frames.base()), frames.leftWheel(), wheel(1, state.leftWheel())));
    all.add(Poses.stamped(stamp.header(frames.base()), frames.rightWheel(), wheel(-1, state.rightWheel())));
    return new TFMessage(all);
  }

  private RigidTransform wheel(int side, double angle) {
    return new RigidTransform(
        new org.robotui.geometry.Vector3(0, side * robot.wheels().track() / 2, robot.wheels().radius()),
        new org.robotui.geometry.Quaternion(0, Math.sin(angle / 2), 0, Math.cos(angle / 2)));
  }

  private static RigidTransform turned(double height, double pitch, double yaw) {
    return new RigidTransform(
        new org.robotui.geometry.Vector3(0, 0, height),
        org.robotui.geometry.Quaternion.fromRollPitchYaw(0, pitch, yaw));
  }

  PoseWithCovarianceStamped estimate(RobotState state, Stamp stamp) {
    double[] covariance = state.lost() ? planar(1, 0.5) : planar(0.003, 0.001);
    return new PoseWithCovarianceStamped(
        stamp.header(Frames.MAP), new PoseWithCovariance(Poses.pose(state.estimate()), covariance));
  }

  Path path(List<Pose2> path, Stamp stamp) {
    Header header = stamp.header(Frames.MAP);
    return new Path(header, path.stream().map(pose -> new PoseStamped(header, Poses.pose(pose))).toList());
  }

  PolygonStamped footprint(RobotState state, Stamp stamp) {
    Pose2 place = state.estimate();
    List<Point32> corners = new ArrayList<>();
    for (int i = 0; i < FOOTPRINT_CORNERS; i++) {
      double angle = 2 * Math.PI * (i + 0.5) / FOOTPRINT_CORNERS;
      Pose2 corner = place.times(new Pose2(robot.radius() * Math.cos(angle), robot.radius() * Math.sin(angle), 0));
      corners.add(new Point32((float) corner.x(), (float) corner.y(), 0));
    }
    return new PolygonStamped(stamp.header(Frames.MAP), new Polygon(corners));
  }

  JointState joints(RobotState state, Stamp stamp) {
    Speed speed = state.speed();
    double half = speed.angular() * robot.wheels().track() / 2;
    double left = (speed.linear() - half) / robot.wheels().radius();
    double right = (speed.linear() + half) / robot.wheels().radius();
    return state.head()
        .map(head -> joints(stamp, List.of("left_wheel_joint", "right_wheel_joint", "pan_joint", "tilt_joint"),
            new double[]{state.leftWheel(), state.rightWheel(), head.pan(), head.tilt()},
            new double[]{left, right, head.panSpeed(), head.tiltSpeed()}))
        .orElseGet(() -> joints(stamp, List.of("left_wheel_joint", "right_wheel_joint"),
            new double[]{state.leftWheel(), state.rightWheel()}, new double[]{left, right}));
  }

  private static JointState joints(Stamp stamp, List<String> names, double[] positions, double[] velocities) {
    return new JointState(stamp.header(""), names, positions, velocities, new double[0]);
  }

  Imu imu(org.robotui.sim.internal.sensor.Imu imu, Stamp stamp) {
    double gravity = org.robotui.sim.internal.sensor.Imu.GRAVITY;
    return new Imu(
        stamp.header(frames.imu()),
        Poses.yaw(imu.heading()), diagonal(1e-6, 1e-6, 1e-2),
        new Vector3(0, 0, imu.turnRate()), diagonal(1.6e-5, 1.6e-5, 1.6e-5),
        new Vector3(imu.forward(), imu.sideways(), gravity), diagonal(9e-4, 9e-4, 9e-4));
  }

  private static double[] diagonal(double x, double y, double z) {
    return new double[]{x, 0, 0, 0, y, 0, 0, 0, z};
  }

  BatteryState battery(RobotState state, Stamp stamp) {
    RobotState.BatteryReading battery = state.battery();
    return new BatteryState(
        stamp.header(frames.base()),
        (float) battery.voltage(), Float.NaN, (float) battery.current(), (float) battery.charge(),
        (float) Battery.CAPACITY, (float) Battery.CAPACITY, (float) battery.level(),
        supplyStatus(battery),
        BatteryState.POWER_SUPPLY_HEALTH_GOOD, BatteryState.POWER_SUPPLY_TECHNOLOGY_UNKNOWN,
        true, new float[0], new float[0], "base", "");
  }

  private static int supplyStatus(RobotState.BatteryReading battery) {
    if (battery.charging()) {
      return BatteryState.POWER_SUPPLY_STATUS_CHARGING;
    }
    return battery.level() >= 1
        ? BatteryState.POWER_SUPPLY_STATUS_FULL
        : BatteryState.POWER_SUPPLY_STATUS_DISCHARGING;
  }
}
