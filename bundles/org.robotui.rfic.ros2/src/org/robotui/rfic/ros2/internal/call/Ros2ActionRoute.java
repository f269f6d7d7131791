package org.robotui.rfic.ros2.internal.call;

import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ThreadFactory;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler.Invocation;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.DynamicMessage;
import org.robotui.message.data.MessageRecord;
import org.robotui.message.topic.ActionCalls;
import org.robotui.message.topic.ActionRoute;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Types.TypedAction;
import org.robotui.ros2.action.Ros2ActionClient;
import org.robotui.ros2.action.Ros2ActionOptions;
import org.robotui.ros2.action.Ros2GoalEnd;
import org.robotui.ros2.action.Ros2GoalHandle;
import org.robotui.ros2.action.Ros2GoalListener;
import org.robotui.ros2.action.Ros2GoalOutcome;
import org.robotui.ros2.action.Ros2GoalPhase;

/**
 * An action of ROS 2, whose services and topics are ours while it is open.
 *
 * @param client our end of it
 */
public record Ros2ActionRoute(Ros2ActionClient client) implements ActionRoute {

  /**
   * Opens the ends of an action.
   *
   * @param node sends
   * @param action its name
   * @param threads makes the thread that notices the loss of the server
   * @return the route
   * @throws CallException where nobody serves the action, or its type is not known
   */
  public static Ros2ActionRoute open(Ros2Node node, String action, ThreadFactory threads) throws CallException {
    TypedAction type = CallOutcomes.found(node.context().types().action(Ros2Services.name(action)));
    return new Ros2ActionRoute(Ros2ActionClient.open(node, action, type, Ros2ActionOptions.standard(threads)));
  }

  @Override
  public Underway send(Map<String, Object> goal, Invocation<ActionRequest> told, Duration patience)
      throws CallException {
    return new TakenGoal(CallOutcomes.value(client.send(goal, listener(told), patience)));
  }

  private static Ros2GoalListener listener(Invocation<ActionRequest> told) {
    return new Ros2GoalListener() {
      @Override
      public void onPhase(Ros2GoalPhase phase) {
        ActionCalls.tell(told, phase, "");
      }

      @Override
      public void onFeedback(DynamicMessage feedback) {
        told.feedback(new MessageRecord(feedback));
      }
    };
  }

  @Override
  public void cancelAll(Duration patience) {
    client.cancelAll(patience);
  }

  @Override
  public void close() {
    client.close();
  }

  private record TakenGoal(Ros2GoalHandle goal) implements Underway {
    @Override
    public CompletionStage<ActionReply> done() {
      return goal.done().thenApply(TakenGoal::reply);
    }

    private static ActionReply reply(Ros2GoalOutcome outcome) {
      return new ActionReply(end(outcome.end()), outcome.text(),
          outcome.result().<DynamicRecord>map(MessageRecord::new));
    }

    private static ActionReply.End end(Ros2GoalEnd end) {
      return switch (end) {
        case SUCCEEDED -> ActionReply.End.SUCCEEDED;
        case ABORTED -> ActionReply.End.ABORTED;
        case CANCELED -> ActionReply.End.PREEMPTED;
        case REJECTED -> ActionReply.End.REJECTED;
        case LOST -> ActionReply.End.LOST;
      };
    }

    @Override
    public void cancel() {
      goal.cancel();
    }
  }
}
