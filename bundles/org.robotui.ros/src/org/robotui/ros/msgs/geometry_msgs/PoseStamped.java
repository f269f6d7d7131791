package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A pose with time and frame ({@code geometry_msgs/PoseStamped}).
 *
 * @param header time and frame
 * @param pose   the pose
 */
public record PoseStamped(Header header, Pose pose) {

  /** Between records and bytes. */
  public static final RecordCodec<PoseStamped> CODEC =
      RecordCodec.of("geometry_msgs/PoseStamped", PoseStamped::read, PoseStamped::write);

  private static PoseStamped read(MessageReader in) throws MessageException {
    return new PoseStamped(in.nested("header", Header.CODEC), in.nested("pose", Pose.CODEC));
  }

  private static void write(PoseStamped m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Pose.CODEC.encode(m.pose, out);
  }
}
