package org.robotui.sim.internal.swarm;

import java.util.List;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.actionlib_msgs.GoalStatusArray;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.message.ros.nav_msgs.Path;
import org.robotui.message.ros.sensor_msgs.BatteryState;
import org.robotui.message.ros.sensor_msgs.LaserScan;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;

/**
 * A robot of a swarm as a ROS node in a namespace of its own. Ended by {@code rosnode kill}, it is gone, and the others
 * go on.
 */
final class SwarmRobot {
  private static final int BEAMS = 36;
  private static final int ODOMETRY = 2;
  private static final int SCAN = 5;
  private static final int STATUS = 10;
  private static final int BATTERY = 20;

  private final Walker walker;
  private final SwarmMessages messages;
  private final Publisher<Odometry> odometry;
  private final Publisher<TFMessage> transforms;
  private final Publisher<LaserScan> scan;
  private final Publisher<BatteryState> battery;
  private final Publisher<GoalStatusArray> status;
  private final Publisher<Path> plan;
  private volatile boolean gone;

  SwarmRobot(String name, RosNode node, Walker walker) {
    this.walker = walker;
    this.messages = new SwarmMessages(name, walker);
    PublisherOptions options = PublisherOptions.standard();
    odometry = node.publisher("odom", RecordCodec.of(Odometry.class), options);
    transforms = node.publisher("/tf", RecordCodec.of(TFMessage.class), options);
    scan = node.publisher("scan", RecordCodec.of(LaserScan.class), options);
    battery = node.publisher("battery_state", RecordCodec.of(BatteryState.class), options);
    status = node.publisher("move_base/status", RecordCodec.of(GoalStatusArray.class), options);
    plan = node.publisher("plan", RecordCodec.of(Path.class), options);
    node.subscriber("cmd_vel", RecordCodec.of(Twist.class), SubscriberOptions.standard(),
        (twist, from) -> drive(twist));
    node.subscriber("move_base_simple/goal", RecordCodec.of(PoseStamped.class), SubscriberOptions.standard(),
        (goal, from) -> go(goal));
    node.whenClosed().thenRun(() -> gone = true);
  }

  private void drive(Twist twist) {
    if (Double.isFinite(twist.linear().x() + twist.angular().z())) {
      walker.drive(twist.linear().x(), twist.angular().z());
    }
  }

  private void go(PoseStamped goal) {
    Point place = goal.pose().position();
    if (Double.isFinite(place.x() + place.y())) {
      walker.go(new Walker.Goal(place.x(), place.y()));
    }
  }

  boolean isGone() {
    return gone;
  }

  Walker walker() {
    return walker;
  }

  /** Publishes what is due; each robot at steps of its own, so that they do not all speak at once. */
  void publish(long step, long stamp, List<Walker> all) {
    if (step % ODOMETRY == 0) {
      odometry.publish(messages.odometry(stamp));
      transforms.publish(messages.transforms(stamp));
    }
    if (step % SCAN == 0) {
      scan.publish(messages.scan(stamp, walker.scan(BEAMS, all)));
    }
    if (step % STATUS == 0) {
      status.publish(messages.status(stamp));
      plan.publish(messages.plan(stamp));
    }
    if (step % BATTERY == 0) {
      battery.publish(messages.battery(stamp));
    }
  }
}
