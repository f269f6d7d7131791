package org.robotui.ros.msgs.visualization_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.geometry_msgs.Pose;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Where an interactive marker is now ({@code visualization_msgs/InteractiveMarkerPose}).
 *
 * @param header time and frame
 * @param pose   where it is
 * @param name   of the marker
 */
public record InteractiveMarkerPose(Header header, Pose pose, String name) {

  /** Between records and bytes. */
  public static final RecordCodec<InteractiveMarkerPose> CODEC =
      RecordCodec.of("visualization_msgs/InteractiveMarkerPose", InteractiveMarkerPose::read, InteractiveMarkerPose::write);

  private static InteractiveMarkerPose read(MessageReader in) throws MessageException {
    return new InteractiveMarkerPose(
        in.nested("header", Header.CODEC),
        in.nested("pose", Pose.CODEC),
        in.string("name"));
  }

  private static void write(InteractiveMarkerPose m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Pose.CODEC.encode(m.pose, out);
    out.string(m.name);
  }
}
