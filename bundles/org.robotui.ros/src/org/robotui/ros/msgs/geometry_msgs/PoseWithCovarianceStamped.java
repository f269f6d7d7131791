package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * An uncertain pose with time and frame ({@code geometry_msgs/PoseWithCovarianceStamped}).
 *
 * @param header time and frame
 * @param pose   the pose
 */
public record PoseWithCovarianceStamped(Header header, PoseWithCovariance pose) {

  /** Between records and bytes. */
  public static final RecordCodec<PoseWithCovarianceStamped> CODEC =
      RecordCodec.of("geometry_msgs/PoseWithCovarianceStamped", PoseWithCovarianceStamped::read, PoseWithCovarianceStamped::write);

  private static PoseWithCovarianceStamped read(MessageReader in) throws MessageException {
    return new PoseWithCovarianceStamped(
        in.nested("header", Header.CODEC),
        in.nested("pose", PoseWithCovariance.CODEC));
  }

  private static void write(PoseWithCovarianceStamped m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    PoseWithCovariance.CODEC.encode(m.pose, out);
  }
}
