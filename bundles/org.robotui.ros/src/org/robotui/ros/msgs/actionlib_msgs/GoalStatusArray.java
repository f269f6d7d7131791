package org.robotui.ros.msgs.actionlib_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * States of an action server's goals ({@code actionlib_msgs/GoalStatusArray}).
 *
 * @param header     time
 * @param statusList the states
 */
public record GoalStatusArray(Header header, List<GoalStatus> statusList) {

  /** Between records and bytes. */
  public static final RecordCodec<GoalStatusArray> CODEC =
      RecordCodec.of("actionlib_msgs/GoalStatusArray", GoalStatusArray::read, GoalStatusArray::write);

  /** Keeps immutable copies of lists. */
  public GoalStatusArray {
    statusList = List.copyOf(statusList);
  }

  private static GoalStatusArray read(MessageReader in) throws MessageException {
    return new GoalStatusArray(in.nested("header", Header.CODEC), in.list("status_list", GoalStatus.CODEC));
  }

  private static void write(GoalStatusArray m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    GoalStatus.CODEC.encodeAll(m.statusList, out);
  }
}
