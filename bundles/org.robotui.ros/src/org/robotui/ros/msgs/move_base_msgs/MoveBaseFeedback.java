package org.robotui.ros.msgs.move_base_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.geometry_msgs.PoseStamped;

/**
 * Tells of a drive ({@code move_base_msgs/MoveBaseFeedback}).
 *
 * @param basePosition where the robot is
 */
public record MoveBaseFeedback(PoseStamped basePosition) {

  /** Between records and bytes. */
  public static final RecordCodec<MoveBaseFeedback> CODEC =
      RecordCodec.of("move_base_msgs/MoveBaseFeedback", MoveBaseFeedback::read, MoveBaseFeedback::write);

  private static MoveBaseFeedback read(MessageReader in) throws MessageException {
    return new MoveBaseFeedback(in.nested("base_position", PoseStamped.CODEC));
  }

  private static void write(MoveBaseFeedback m, MessageWriter out) {
    PoseStamped.CODEC.encode(m.basePosition, out);
  }
}
