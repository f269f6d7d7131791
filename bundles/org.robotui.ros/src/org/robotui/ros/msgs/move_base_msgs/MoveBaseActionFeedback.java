package org.robotui.ros.msgs.move_base_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.actionlib_msgs.GoalStatus;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Carries a feedback to the clients ({@code move_base_msgs/MoveBaseActionFeedback}).
 *
 * @param header   time
 * @param status   names the goal, and its state
 * @param feedback the feedback
 */
public record MoveBaseActionFeedback(Header header, GoalStatus status, MoveBaseFeedback feedback) {

  /** Between records and bytes. */
  public static final RecordCodec<MoveBaseActionFeedback> CODEC =
      RecordCodec.of("move_base_msgs/MoveBaseActionFeedback", MoveBaseActionFeedback::read, MoveBaseActionFeedback::write);

  private static MoveBaseActionFeedback read(MessageReader in) throws MessageException {
    return new MoveBaseActionFeedback(
        in.nested("header", Header.CODEC),
        in.nested("status", GoalStatus.CODEC),
        in.nested("feedback", MoveBaseFeedback.CODEC));
  }

  private static void write(MoveBaseActionFeedback m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    GoalStatus.CODEC.encode(m.status, out);
    MoveBaseFeedback.CODEC.encode(m.feedback, out);
  }
}
