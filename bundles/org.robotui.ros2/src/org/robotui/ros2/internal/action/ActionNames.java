package org.robotui.ros2.internal.action;

import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.Ros2Types.TypedAction;
import java.nio.ByteBuffer;
import org.robotui.message.DynamicMessage;
import org.robotui.ros2.internal.msgs.CancelGoalAsk;
import org.robotui.ros2.internal.msgs.CancelGoalReply;
import org.robotui.ros2.name.Ros2Name;

/**
 * What an action is made of.
 *
 * @param action its name
 * @param type its type
 */
record ActionNames(Ros2Name action, TypedAction type) {

  private String part(String name) {
    return action.join("_action/" + name).text();
  }

  String sendGoal() {
    return part("send_goal");
  }

  String getResult() {
    return part("get_result");
  }

  String cancelGoal() {
    return part("cancel_goal");
  }

  String feedback() {
    return part("feedback");
  }

  String status() {
    return part("status");
  }

  Ros2ServiceCodec<DynamicMessage, DynamicMessage> sending() {
    return Ros2ServiceCodec.of(type.name().part("SendGoal"), type.schema().sendGoal());
  }

  Ros2ServiceCodec<DynamicMessage, DynamicMessage> getting() {
    return Ros2ServiceCodec.of(type.name().part("GetResult"), type.schema().getResult());
  }

  /** Results as bytes: those of another version of the type tell the end of the goal all the same. */
  Ros2ServiceCodec<DynamicMessage, ByteBuffer> gettingBytes() {
    Ros2ServiceCodec<DynamicMessage, DynamicMessage> known = getting();
    return new Ros2ServiceCodec<>(known.type(), known.hash(), known.request(),
        Ros2Codec.raw(known.response().type(), known.response().hash()));
  }

  static Ros2ServiceCodec<CancelGoalAsk, CancelGoalReply> cancelling() {
    return Ros2ServiceCodec.of("action_msgs/srv/CancelGoal", CancelGoalAsk.class, CancelGoalReply.class);
  }

  Ros2Codec<DynamicMessage> telling() {
    return Ros2Codec.of(type.name().part("FeedbackMessage"), type.schema().feedbackMessage());
  }
}
