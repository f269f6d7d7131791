package org.robotui.ros.msgs.geometry_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Several poses ({@code geometry_msgs/PoseArray}).
 *
 * @param header time and frame
 * @param poses  the poses
 */
public record PoseArray(Header header, List<Pose> poses) {

  /** Between records and bytes. */
  public static final RecordCodec<PoseArray> CODEC =
      RecordCodec.of("geometry_msgs/PoseArray", PoseArray::read, PoseArray::write);

  /** Keeps immutable copies of lists. */
  public PoseArray {
    poses = List.copyOf(poses);
  }

  private static PoseArray read(MessageReader in) throws MessageException {
    return new PoseArray(in.nested("header", Header.CODEC), in.list("poses", Pose.CODEC));
  }

  private static void write(PoseArray m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Pose.CODEC.encodeAll(m.poses, out);
  }
}
