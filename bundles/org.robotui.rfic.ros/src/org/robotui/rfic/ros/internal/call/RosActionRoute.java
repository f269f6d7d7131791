package org.robotui.rfic.ros.internal.call;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ThreadFactory;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler.Invocation;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageRegistry;
import org.robotui.message.data.MessageRecord;
import org.robotui.message.topic.ActionCalls;
import org.robotui.message.topic.ActionRoute;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.ros.GraphName;
import org.robotui.ros.RosNode;
import org.robotui.ros.action.ActionClient;
import org.robotui.ros.action.ActionInfo;
import org.robotui.ros.action.ActionOptions;
import org.robotui.ros.action.ActionType;
import org.robotui.ros.action.Actions;
import org.robotui.ros.action.GoalHandle;
import org.robotui.ros.action.GoalListener;
import org.robotui.ros.action.GoalOutcome;
import org.robotui.ros.action.GoalPhase;

/**
 * An action of ROS 1, whose topics are ours while it is open.
 *
 * @param client our end of it
 */
public record RosActionRoute(ActionClient client) implements ActionRoute {

  /**
   * Opens the topics of an action.
   *
   * @param node sends
   * @param action its name
   * @param registry knows the definitions
   * @param threads makes the thread that notices the loss of the server
   * @return the route
   * @throws CallException where nobody serves the action, or its type is not known
   */
  public static RosActionRoute open(RosNode node, String action, MessageRegistry registry, ThreadFactory threads)
      throws CallException {
    ActionType type = type(node, action, registry);
    return new RosActionRoute(
        ActionClient.open(node, GraphName.of(action), type, registry, ActionOptions.standard(threads)));
  }

  private static ActionType type(RosNode node, String action, MessageRegistry registry) throws CallException {
    List<ActionInfo> all = CallOutcomes.value(Actions.list(node.master()));
    ActionInfo info = all.stream().filter(a -> a.name().text().equals(action)).findFirst()
        .orElseThrow(() -> new CallException("nobody serves the action " + action));
    return CallOutcomes.found(ActionType.find(info.type(), registry));
  }

  @Override
  public Underway send(Map<String, Object> goal, Invocation<ActionRequest> told, Duration patience)
      throws CallException {
    return new Sent(CallOutcomes.value(client.send(goal, listener(told), patience)));
  }

  private static GoalListener listener(Invocation<ActionRequest> told) {
    return new GoalListener() {
      @Override
      public void onPhase(GoalPhase phase, String text) {
        ActionCalls.tell(told, phase, text);
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

  private record Sent(GoalHandle goal) implements Underway {
    @Override
    public CompletionStage<ActionReply> done() {
      return goal.done().thenApply(Sent::reply);
    }

    private static ActionReply reply(GoalOutcome outcome) {
      return new ActionReply(ActionReply.End.valueOf(outcome.end().name()), outcome.text(),
          outcome.result().<DynamicRecord>map(MessageRecord::new));
    }

    @Override
    public void cancel() {
      goal.cancel();
    }
  }
}
