package org.robotui.ros.msgs.nav_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.geometry_msgs.PoseWithCovariance;
import org.robotui.ros.msgs.geometry_msgs.TwistWithCovariance;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Pose and velocity as the robot estimates them ({@code nav_msgs/Odometry}).
 *
 * @param header       time and frame of the pose
 * @param childFrameId frame of the velocity
 * @param pose         the pose
 * @param twist        the velocity
 */
public record Odometry(Header header, String childFrameId, PoseWithCovariance pose, TwistWithCovariance twist) {

  /** Between records and bytes. */
  public static final RecordCodec<Odometry> CODEC =
      RecordCodec.of("nav_msgs/Odometry", Odometry::read, Odometry::write);

  private static Odometry read(MessageReader in) throws MessageException {
    return new Odometry(
        in.nested("header", Header.CODEC),
        in.string("child_frame_id"),
        in.nested("pose", PoseWithCovariance.CODEC),
        in.nested("twist", TwistWithCovariance.CODEC));
  }

  private static void write(Odometry m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.string(m.childFrameId);
    PoseWithCovariance.CODEC.encode(m.pose, out);
    TwistWithCovariance.CODEC.encode(m.twist, out);
  }
}
