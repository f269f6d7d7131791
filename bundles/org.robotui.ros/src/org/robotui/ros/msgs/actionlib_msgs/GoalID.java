package org.robotui.ros.msgs.actionlib_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.message.Stamps;

/**
 * Names one goal of an action ({@code actionlib_msgs/GoalID}).
 *
 * @param stamp when the goal was sent, nanoseconds since the epoch of the sender's clock
 * @param id    unique name
 */
public record GoalID(long stamp, String id) {

  /** Between records and bytes. */
  public static final RecordCodec<GoalID> CODEC =
      RecordCodec.of("actionlib_msgs/GoalID", GoalID::read, GoalID::write);

  private static GoalID read(MessageReader in) throws MessageException {
    return new GoalID(in.time("stamp"), in.string("id"));
  }

  private static void write(GoalID m, MessageWriter out) {
    Stamps.write(m.stamp, out);
    out.string(m.id);
  }
}
