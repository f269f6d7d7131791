package org.robotui.rfic.recording.internal.lines;

import java.util.List;
import org.robotui.geometry.RigidTransform;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.PoseWithCovariance;
import org.robotui.message.ros.geometry_msgs.PoseWithCovarianceStamped;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.geometry_msgs.Transform;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.message.ros.geometry_msgs.TwistWithCovariance;
import org.robotui.message.ros.geometry_msgs.Vector3;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.message.ros.sensor_msgs.LaserScan;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.recording.RecordedMessage;
import org.robotui.rfic.recording.internal.lines.LineChannels.Moment;

/** What logs of robots on wheels have in common. */
final class LogLineMessages {
  static final String BASE = "base_link";
  static final String ODOM = "odom";
  static final String MAP = "map";
  private static final int COVARIANCE = 36;

  private final LineChannels channels;

  LogLineMessages(LineChannels channels) {
    this.channels = channels;
  }

  static Header header(String frame, Moment moment) {
    return new Header(0, moment.stamp(), frame);
  }

  /** Where the robot is, and how fast, in metres, radians and seconds. */
  List<RecordedMessage> odometry(String topic, RigidTransform pose, double[] speed, Moment moment) {
    Twist twist = new Twist(new Vector3(speed[0], speed[1], 0), new Vector3(0, 0, speed[2]));
    Odometry said = new Odometry(header(ODOM, moment), BASE, new PoseWithCovariance(pose(pose), new double[COVARIANCE]),
        new TwistWithCovariance(twist, new double[COVARIANCE]));
    return List.of(channels.ros(topic, Odometry.class, said, moment), transform(ODOM, BASE, pose, moment));
  }

  RecordedMessage estimate(String topic, RigidTransform pose, Moment moment) {
    return channels.ros(topic, PoseWithCovarianceStamped.class, new PoseWithCovarianceStamped(header(MAP, moment),
        new PoseWithCovariance(pose(pose), new double[COVARIANCE])), moment);
  }

  private static Pose pose(RigidTransform pose) {
    return new Pose(new Point(pose.translation().x(), pose.translation().y(), pose.translation().z()),
        turned(pose));
  }

  private static Quaternion turned(RigidTransform pose) {
    return new Quaternion(pose.rotation().x(), pose.rotation().y(), pose.rotation().z(), pose.rotation().w());
  }

  RecordedMessage transform(String parent, String child, RigidTransform pose, Moment moment) {
    Transform transform = new Transform(
        new Vector3(pose.translation().x(), pose.translation().y(), pose.translation().z()), turned(pose));
    return channels.ros("/tf", TFMessage.class,
        new TFMessage(List.of(new TransformStamped(header(parent, moment), child, transform))), moment);
  }

  /** What is as far as the scanner sees, or farther, is nothing. */
  RecordedMessage scan(String topic, String frame, double start, double step, double farthest, float[] ranges,
      float[] intensities, Moment moment) {
    for (int i = 0; i < ranges.length; i++) {
      ranges[i] = ranges[i] >= farthest * (1 - 1e-6) ? Float.POSITIVE_INFINITY : ranges[i];
    }
    double end = start + step * Math.max(0, ranges.length - 1);
    return channels.ros(topic, LaserScan.class, new LaserScan(header(frame, moment), (float) start, (float) end,
        (float) step, 0, 0, 0, (float) farthest, ranges, intensities), moment);
  }
}
