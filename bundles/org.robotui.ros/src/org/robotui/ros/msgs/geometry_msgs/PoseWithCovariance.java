package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A pose and how sure it is ({@code geometry_msgs/PoseWithCovariance}).
 *
 * @param pose       the pose
 * @param covariance 6 x 6, row by row: x, y, z, rotations about x, y, z
 */
public record PoseWithCovariance(Pose pose, double[] covariance) {

  /** Between records and bytes. */
  public static final RecordCodec<PoseWithCovariance> CODEC =
      RecordCodec.of("geometry_msgs/PoseWithCovariance", PoseWithCovariance::read, PoseWithCovariance::write);

  /** Checks the lengths of fixed arrays. */
  public PoseWithCovariance {
    RecordCodec.requireLength("covariance", covariance.length, 36);
  }

  private static PoseWithCovariance read(MessageReader in) throws MessageException {
    return new PoseWithCovariance(in.nested("pose", Pose.CODEC), in.doubles("covariance", 36));
  }

  private static void write(PoseWithCovariance m, MessageWriter out) {
    Pose.CODEC.encode(m.pose, out);
    out.doubles(m.covariance);
  }
}
