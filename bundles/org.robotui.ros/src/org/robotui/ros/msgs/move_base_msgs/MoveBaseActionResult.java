package org.robotui.ros.msgs.move_base_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.actionlib_msgs.GoalStatus;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Carries a result to the clients ({@code move_base_msgs/MoveBaseActionResult}).
 *
 * @param header time
 * @param status names the goal, and its state
 * @param result the result
 */
public record MoveBaseActionResult(Header header, GoalStatus status, MoveBaseResult result) {

  /** Between records and bytes. */
  public static final RecordCodec<MoveBaseActionResult> CODEC =
      RecordCodec.of("move_base_msgs/MoveBaseActionResult", MoveBaseActionResult::read, MoveBaseActionResult::write);

  private static MoveBaseActionResult read(MessageReader in) throws MessageException {
    return new MoveBaseActionResult(
        in.nested("header", Header.CODEC),
        in.nested("status", GoalStatus.CODEC),
        in.nested("result", MoveBaseResult.CODEC));
  }

  private static void write(MoveBaseActionResult m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    GoalStatus.CODEC.encode(m.status, out);
    MoveBaseResult.CODEC.encode(m.result, out);
  }
}
