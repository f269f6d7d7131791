package org.robotui.sim.internal.swarm;

import java.util.List;
import org.robotui.message.ros.actionlib_msgs.GoalID;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;
import org.robotui.message.ros.actionlib_msgs.GoalStatusArray;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.geometry_msgs.PoseWithCovariance;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.TwistWithCovariance;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.message.ros.nav_msgs.Path;
import org.robotui.message.ros.sensor_msgs.BatteryState;
import org.robotui.message.ros.sensor_msgs.LaserScan;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.tf2_msgs.TFMessage;

/** What a robot of a swarm says. Its frames carry its name before them; the map is that of all. */
final class SwarmMessages {
  private static final String MAP = "map";
  private static final Quaternion STRAIGHT = new Quaternion(0, 0, 0, 1);
  private static final double EMPTY_VOLTAGE = 22;
  private static final double FULL_VOLTAGE = 25.2;

  private final Walker walker;
  private final String odom;
  private final String base;
  private long sequence;

  SwarmMessages(String name, Walker walker) {
    this.walker = walker;
    odom = name + "/odom";
    base = name + "/base_link";
  }

  private Header header(long stamp, String frame) {
    return new Header(sequence++, stamp, frame);
  }

  private static Quaternion turned(double yaw) {
    return new Quaternion(0, 0, Math.sin(yaw / 2), Math.cos(yaw / 2));
  }

  Odometry odometry(long stamp) {
    Pose pose = new Pose(new Point(walker.x(), walker.y(), 0), turned(walker.yaw()));
    Twist twist = new Twist(new Vector3(walker.linear(), 0, 0), new Vector3(0, 0, walker.angular()));
    return new Odometry(header(stamp, odom), base, new PoseWithCovariance(pose, new double[36]),
        new TwistWithCovariance(twist, new double[36]));
  }

  TFMessage transforms(long stamp) {
    return new TFMessage(List.of(
        new TransformStamped(header(stamp, MAP), odom, new Transform(new Vector3(0, 0, 0), STRAIGHT)),
        new TransformStamped(header(stamp, odom), base,
            new Transform(new Vector3(walker.x(), walker.y(), 0), turned(walker.yaw())))));
  }

  LaserScan scan(long stamp, float[] ranges) {
    double step = 2 * Math.PI / ranges.length;
    return new LaserScan(header(stamp, base), 0, (float) (2 * Math.PI - step), (float) step, 0, 0.25f, 0.05f,
        (float) Hall.SIGHT, ranges, new float[0]);
  }

  BatteryState battery(long stamp) {
    float charge = (float) walker.charge();
    return new BatteryState(header(stamp, base), (float) (EMPTY_VOLTAGE + charge * (FULL_VOLTAGE - EMPTY_VOLTAGE)),
        Float.NaN, -1, charge * 10, 10, 10,
        charge, BatteryState.POWER_SUPPLY_STATUS_DISCHARGING, BatteryState.POWER_SUPPLY_HEALTH_GOOD,
        BatteryState.POWER_SUPPLY_TECHNOLOGY_UNKNOWN, true, new float[0], new float[0], "base", "");
  }

  GoalStatusArray status(long stamp) {
    return new GoalStatusArray(header(stamp, ""), List.of(new GoalStatus(new GoalID(stamp, "task"), state(), words())));
  }

  private int state() {
    return switch (walker.task()) {
      case PATROLLING, GOING -> GoalStatus.ACTIVE;
      case ARRIVED -> GoalStatus.SUCCEEDED;
      case GAVE_UP -> GoalStatus.ABORTED;
      case STANDING, DRIVEN -> GoalStatus.PREEMPTED;
    };
  }

  private String words() {
    return switch (walker.task()) {
      case PATROLLING -> "patrolling";
      case GOING -> walker.goal().map(g -> "going to %.1f %.1f".formatted(g.x(), g.y())).orElse("going");
      case ARRIVED -> "arrived";
      case GAVE_UP -> "gave up: the way is blocked";
      case STANDING -> "standing";
      case DRIVEN -> "driven by hand";
    };
  }

  Path plan(long stamp) {
    Header map = header(stamp, MAP);
    List<PoseStamped> way = walker.task() != Walker.Task.GOING ? List.of()
        : walker.goal().stream()
            .flatMap(g -> List.of(new Point(walker.x(), walker.y(), 0), new Point(g.x(), g.y(), 0)).stream())
            .map(p -> new PoseStamped(map, new Pose(p, STRAIGHT))).toList();
    return new Path(map, way);
  }
}
