package org.robotui.ros.action;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.actionlib_msgs.GoalID;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;
import org.robotui.message.ros.actionlib_msgs.GoalStatusArray;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.message.ros.move_base_msgs.MoveBaseActionFeedback;
import org.robotui.message.ros.move_base_msgs.MoveBaseActionGoal;
import org.robotui.message.ros.move_base_msgs.MoveBaseActionResult;
import org.robotui.message.ros.move_base_msgs.MoveBaseFeedback;
import org.robotui.message.ros.move_base_msgs.MoveBaseResult;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;

/** The five topics of an action whose server says whatever a test wants. */
final class ScriptedServer {

  static final Header HEADER = new Header(0, 0, "");

  final List<MoveBaseActionGoal> goals = new CopyOnWriteArrayList<>();
  final List<GoalID> cancelled = new CopyOnWriteArrayList<>();
  private final Publisher<GoalStatusArray> status;
  private final Publisher<MoveBaseActionFeedback> feedback;
  private final Publisher<MoveBaseActionResult> result;

  ScriptedServer(RosNode node) {
    node.subscriber("/drive/goal", RecordCodec.of(MoveBaseActionGoal.class), SubscriberOptions.standard(),
        (goal, from) -> goals.add(goal));
    node.subscriber("/drive/cancel", RecordCodec.of(GoalID.class), SubscriberOptions.standard(),
        (id, from) -> cancelled.add(id));
    status = node.publisher("/drive/status", RecordCodec.of(GoalStatusArray.class), PublisherOptions.standard());
    feedback =
        node.publisher("/drive/feedback", RecordCodec.of(MoveBaseActionFeedback.class), PublisherOptions.standard());
    result = node.publisher("/drive/result", RecordCodec.of(MoveBaseActionResult.class), PublisherOptions.standard());
  }

  static GoalStatus about(String id, int code, String text) {
    return new GoalStatus(new GoalID(0, id), code, text);
  }

  void report(GoalStatus... all) {
    status.publish(new GoalStatusArray(HEADER, List.of(all)));
  }

  void feedback(String id, double x) {
    PoseStamped pose = new PoseStamped(HEADER, new Pose(new Point(x, 0, 0), new Quaternion(0, 0, 0, 1)));
    feedback.publish(new MoveBaseActionFeedback(HEADER, about(id, GoalStatus.ACTIVE, ""), new MoveBaseFeedback(pose)));
  }

  void result(String id, int code, String text) {
    result.publish(new MoveBaseActionResult(HEADER, about(id, code, text), new MoveBaseResult()));
  }
}
