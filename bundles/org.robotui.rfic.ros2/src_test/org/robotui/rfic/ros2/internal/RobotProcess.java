package org.robotui.rfic.ros2.internal;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.TreeSet;
import java.util.concurrent.Executors;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.PoseWithCovariance;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.TwistWithCovariance;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.message.ros.sensor_msgs.LaserScan;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Context;
import org.robotui.ros2.Ros2Environment;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Options;
import org.robotui.ros2.Ros2Publisher;
import org.robotui.ros2.Ros2SubscriberOptions;
import org.robotui.ros2.graph.GraphEnd;
import org.robotui.ros2.graph.GraphState;

/**
 * A base with a laser, in a process of its own, which can be stopped and killed. A line on standard input is an order;
 * what it hears and answers stands on standard output.
 */
final class RobotProcess {
  static final long STAMP = 1_700_000_000_000_000_500L;
  private static final Ros2Codec<LaserScan> SCANS = Ros2Codec.of(LaserScan.class);

  private final Ros2Context context;
  private final Ros2Publisher<Odometry> poses;
  private final Ros2Publisher<LaserScan> scans;
  private final Ros2Publisher<ByteBuffer> nonsense;

  private RobotProcess(Ros2Context context) {
    this.context = context;
    Ros2Node node = context.node("robot");
    poses = node.publisher("odom", Ros2Codec.of(Odometry.class), QosProfiles.DEFAULT);
    scans = node.publisher("scan", SCANS, QosProfiles.SENSOR_DATA);
    nonsense = node.publisher("scan", Ros2Codec.raw(SCANS.type(), SCANS.hash()), QosProfiles.SENSOR_DATA);
    node.subscriber("cmd_vel", Ros2Codec.of(Twist.class), Ros2SubscriberOptions.of(QosProfiles.DEFAULT),
        (twist, from) -> say("heard " + numbers(twist.linear()) + " " + numbers(twist.angular())));
  }

  public static void main(String[] arguments) throws IOException {
    int domain = Integer.parseInt(arguments[0]);
    try (Ros2Context context = Ros2Context.open(Ros2Environment.local(domain),
        Ros2Options.standard(Executors.defaultThreadFactory()))) {
      RobotProcess robot = new RobotProcess(context);
      say("= ready");
      BufferedReader orders = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
      for (String order = orders.readLine(); order != null; order = orders.readLine()) {
        robot.obey(order);
      }
    }
  }

  private static void say(String line) {
    System.out.println(line);
    System.out.flush();
  }

  private static String numbers(Vector3 v) {
    return String.format(Locale.ROOT, "%s %s %s", v.x(), v.y(), v.z());
  }

  private void obey(String order) {
    switch (order) {
      case "odom" -> poses.publish(pose());
      case "scan" -> scans.publish(new LaserScan(new Header(0, STAMP, "laser"), -1, 1, 1, 0, 0.05f, 0.1f, 30,
          new float[]{1, Float.NaN, Float.POSITIVE_INFINITY}, new float[0]));
      case "nonsense" -> nonsense.publish(ByteBuffer.wrap(new byte[]{0, 1, 0, 0, 7, 7, 7}));
      case "listeners odom" -> say("= " + poses.numSubscribers());
      case "listeners scan" -> say("= " + scans.numSubscribers());
      case "links" -> say("= " + context.participant().discovery().participants().size());
      case "graph" -> say("= " + String.join(";", graph()));
      default -> throw new IllegalArgumentException(order);
    }
  }

  private static Odometry pose() {
    double[] none = new double[36];
    Pose pose = new Pose(new Point(2, -1, 0.5), new Quaternion(0, 0, Math.sin(0.1), Math.cos(0.1)));
    Twist twist = new Twist(new Vector3(0.2, 0.3, 0.4), new Vector3(-0.1, -0.2, 0.6));
    return new Odometry(new Header(0, STAMP, "odom"), "base_link", new PoseWithCovariance(pose, none),
        new TwistWithCovariance(twist, none));
  }

  private TreeSet<String> graph() {
    GraphState state = context.graph().state();
    TreeSet<String> all = new TreeSet<>();
    state.nodes().forEach(node -> all.add(node.name().text()));
    state.topics().forEach(topic -> {
      List<GraphEnd> ends = new ArrayList<>(topic.publishers());
      ends.addAll(topic.subscribers());
      ends.forEach(end -> all.add(end.guid() + " of " + topic.name()));
    });
    state.services()
        .forEach(service -> service.clients().forEach(end -> all.add(end.guid() + " of " + service.name())));
    return all;
  }
}
