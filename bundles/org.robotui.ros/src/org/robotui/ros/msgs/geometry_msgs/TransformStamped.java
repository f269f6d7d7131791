package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Where a child frame is in its parent frame at a time ({@code geometry_msgs/TransformStamped}).
 *
 * @param header       time and parent frame
 * @param childFrameId the child frame
 * @param transform    parent from child
 */
public record TransformStamped(Header header, String childFrameId, Transform transform) {

  /** Between records and bytes. */
  public static final RecordCodec<TransformStamped> CODEC =
      RecordCodec.of("geometry_msgs/TransformStamped", TransformStamped::read, TransformStamped::write);

  private static TransformStamped read(MessageReader in) throws MessageException {
    return new TransformStamped(
        in.nested("header", Header.CODEC),
        in.string("child_frame_id"),
        in.nested("transform", Transform.CODEC));
  }

  private static void write(TransformStamped m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.string(m.childFrameId);
    Transform.CODEC.encode(m.transform, out);
  }
}
