package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A position and an orientation ({@code geometry_msgs/Pose}).
 *
 * @param position    the position, metres
 * @param orientation the orientation
 */
public record Pose(Point position, Quaternion orientation) {

  /** Between records and bytes. */
  public static final RecordCodec<Pose> CODEC =
      RecordCodec.of("geometry_msgs/Pose", Pose::read, Pose::write);

  private static Pose read(MessageReader in) throws MessageException {
    return new Pose(in.nested("position", Point.CODEC), in.nested("orientation", Quaternion.CODEC));
  }

  private static void write(Pose m, MessageWriter out) {
    Point.CODEC.encode(m.position, out);
    Quaternion.CODEC.encode(m.orientation, out);
  }
}
