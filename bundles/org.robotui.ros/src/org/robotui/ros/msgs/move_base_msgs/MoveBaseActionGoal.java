package org.robotui.ros.msgs.move_base_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.actionlib_msgs.GoalID;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Carries a goal to the server ({@code move_base_msgs/MoveBaseActionGoal}).
 *
 * @param header time
 * @param goalId names the goal
 * @param goal   the goal
 */
public record MoveBaseActionGoal(Header header, GoalID goalId, MoveBaseGoal goal) {

  /** Between records and bytes. */
  public static final RecordCodec<MoveBaseActionGoal> CODEC =
      RecordCodec.of("move_base_msgs/MoveBaseActionGoal", MoveBaseActionGoal::read, MoveBaseActionGoal::write);

  private static MoveBaseActionGoal read(MessageReader in) throws MessageException {
    return new MoveBaseActionGoal(
        in.nested("header", Header.CODEC),
        in.nested("goal_id", GoalID.CODEC),
        in.nested("goal", MoveBaseGoal.CODEC));
  }

  private static void write(MoveBaseActionGoal m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    GoalID.CODEC.encode(m.goalId, out);
    MoveBaseGoal.CODEC.encode(m.goal, out);
  }
}
