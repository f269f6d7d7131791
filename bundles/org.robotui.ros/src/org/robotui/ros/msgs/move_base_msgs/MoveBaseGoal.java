package org.robotui.ros.msgs.move_base_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.geometry_msgs.PoseStamped;

/**
 * Asks to drive to a place ({@code move_base_msgs/MoveBaseGoal}).
 *
 * @param targetPose the place
 */
public record MoveBaseGoal(PoseStamped targetPose) {

  /** Between records and bytes. */
  public static final RecordCodec<MoveBaseGoal> CODEC =
      RecordCodec.of("move_base_msgs/MoveBaseGoal", MoveBaseGoal::read, MoveBaseGoal::write);

  private static MoveBaseGoal read(MessageReader in) throws MessageException {
    return new MoveBaseGoal(in.nested("target_pose", PoseStamped.CODEC));
  }

  private static void write(MoveBaseGoal m, MessageWriter out) {
    PoseStamped.CODEC.encode(m.targetPose, out);
  }
}
