package org.robotui.ros2.internal.action;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.RosValue;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2ServiceClient;
import org.robotui.ros2.Ros2Subscriber;
import org.robotui.ros2.Ros2SubscriberOptions;
import org.robotui.ros2.Ros2Types.TypedAction;
import org.robotui.ros2.action.Ros2ActionClient;
import org.robotui.ros2.action.Ros2ActionOptions;
import org.robotui.ros2.action.Ros2GoalEnd;
import org.robotui.ros2.action.Ros2GoalHandle;
import org.robotui.ros2.action.Ros2GoalListener;
import org.robotui.ros2.internal.link.Waiting;
import org.robotui.ros2.internal.msgs.CancelGoalAsk;
import org.robotui.ros2.internal.msgs.CancelGoalReply;
import org.robotui.ros2.internal.msgs.WireGoalInfo;
import org.robotui.ros2.internal.msgs.WireGoalStatus;
import org.robotui.ros2.internal.msgs.WireGoalStatusArray;
import org.robotui.ros2.name.Ros2Name;

/** The three services and two topics of an action, from the client's side. */
public final class ActionClientLinks implements Ros2ActionClient {

  private final Ros2Name name;
  private final TypedAction type;
  private final Ros2ActionOptions options;
  private final DynamicCodec goalCodec;
  private final DynamicCodec resultCodec;
  private final ClientGoals goals;
  private final Ros2ServiceClient<DynamicMessage, DynamicMessage> sending;
  private final Ros2ServiceClient<DynamicMessage, ByteBuffer> getting;
  private final Ros2ServiceClient<CancelGoalAsk, CancelGoalReply> cancelling;
  private final Ros2Subscriber feedback;
  private final Ros2Subscriber status;
  private volatile boolean closed;

  /**
   * Makes them.
   *
   * @param node the node
   * @param action the action's name
   * @param type the action's type
   * @param options what the owner gives it
   */
  public ActionClientLinks(Ros2Node node, String action, TypedAction type, Ros2ActionOptions options) {
    this.name = node.names().service(action);
    this.type = type;
    this.options = options;
    goalCodec = new DynamicCodec(type.schema().sendGoal().request());
    resultCodec = new DynamicCodec(type.schema().getResult().request());
    ActionNames names = new ActionNames(name, type);
    sending = node.serviceClient(names.sendGoal(), names.sending());
    getting = node.serviceClient(names.getResult(), names.gettingBytes());
    cancelling = node.serviceClient(names.cancelGoal(), ActionNames.cancelling());
    goals = new ClientGoals(name.text(), options, this::ready);
    feedback = node.subscriber(names.feedback(), names.telling(),
        new Ros2SubscriberOptions(QosProfiles.DEFAULT, true), (message, from) -> feedback(message));
    status = node.subscriber(names.status(), Ros2Codec.of(WireGoalStatusArray.class),
        new Ros2SubscriberOptions(QosProfiles.LATCHED, true), (message, from) -> statuses(message.statusList()));
  }

  private void feedback(DynamicMessage message) {
    GoalIds.of(message).flatMap(goals::find)
        .ifPresent(goal -> GoalIds.inner(message, "feedback").ifPresent(goal::feedback));
  }

  /** A server mentions a goal until some time after its end. */
  private void statuses(List<WireGoalStatus> all) {
    Set<String> mentioned = all.stream().map(each -> id(each.goalInfo())).collect(Collectors.toSet());
    all.forEach(each -> goals.find(id(each.goalInfo())).ifPresent(goal -> goal.status(each.status())));
    for (ClientGoal goal : goals.all()) {
      if (!mentioned.contains(goal.id()) && goal.unmentionedNanos() > options.silence().toNanos()) {
        goal.lose("the server of " + name + " does not know the goal any more");
      }
    }
  }

  private static String id(WireGoalInfo info) {
    return GoalIds.text(info.goalId().uuid());
  }

  @Override
  public Ros2Name name() {
    return name;
  }

  @Override
  public TypedAction type() {
    return type;
  }

  @Override
  public boolean ready() {
    return sending.ready() && getting.ready() && cancelling.ready();
  }

  @Override
  public boolean awaitServer(Duration patience) {
    return Waiting.until(patience, () -> closed, this::ready);
  }

  @Override
  public Outcome<Ros2GoalHandle> send(Map<String, ?> values, Ros2GoalListener listener, Duration patience) {
    long deadline = System.nanoTime() + patience.toNanos();
    byte[] id = GoalIds.random();
    try {
      DynamicMessage request = goalCodec.build(Map.of("goal_id", Map.of("uuid", id), "goal", values));
      if (!awaitServer(patience)) {
        return closed ? new Outcome.Failed<>("action " + name + ": the client was closed")
            : new Outcome.TimedOut<>("action " + name + " has no server of type " + type.name(), patience);
      }
      return dispatch(GoalIds.text(id), request, listener, Duration.ofNanos(deadline - System.nanoTime()));
    } catch (MessageException e) {
      return new Outcome.Refused<>("goal of " + name + ": " + e.getMessage());
    }
  }

  /** The goal is known before it is sent, so that no word of it comes too early. */
  private Outcome<Ros2GoalHandle> dispatch(String id, DynamicMessage request, Ros2GoalListener listener,
      Duration patience) {
    ClientGoal goal = new ClientGoal(id, listener, this::cancel, goals::remove);
    if (!goals.add(goal)) {
      return new Outcome.Refused<>("action " + name + ": too many goals are on their way, or the client was closed");
    }
    Outcome<DynamicMessage> answer = sending.call(request, patience);
    boolean accepted = answer.toOptional().flatMap(message -> message.field("accepted"))
        .filter(new RosValue.Flag(true)::equals).isPresent();
    if (accepted) {
      goal.accepted();
      ask(goal);
      return new Outcome.Done<>(goal);
    }
    if (answer instanceof Outcome.Done) {
      String reason = "the server of " + name + " did not want the goal";
      goal.end(Ros2GoalEnd.REJECTED, reason, Optional.empty());
      return new Outcome.Refused<>(reason);
    }
    // it may have been taken all the same, and nobody here would know of it
    cancel(goal);
    goal.lose(answer.reason());
    return answer.map(never -> goal);
  }

  private void ask(ClientGoal goal) {
    try {
      DynamicMessage request = resultCodec.build(Map.of("goal_id", Map.of("uuid", GoalIds.bytes(goal.id()))));
      getting.send(request).whenComplete((answer, failure) -> ended(goal, answer));
    } catch (MessageException e) {
      throw new IllegalStateException("an identifier fits to its type", e);
    }
  }

  private void ended(ClientGoal goal, Outcome<ByteBuffer> answer) {
    if (!(answer instanceof Outcome.Done<ByteBuffer> done)) {
      goal.lose(answer.reason());
      return;
    }
    GoalResult result = GoalResult.read(done.value(), type.schema().getResult().response());
    GoalStatuses.end(result.status()).ifPresentOrElse(end -> goal.end(end, result.fault(), result.result()),
        () -> goal.end(Ros2GoalEnd.LOST, "the server of " + name + " sent a result with status " + result.status()
            + ", which is no end: it does not know the goal", result.result()));
  }

  private void cancel(ClientGoal goal) {
    cancelling.send(new CancelGoalAsk(new WireGoalInfo(GoalIds.wire(goal.id()), 0)));
  }

  @Override
  public boolean cancelAll(Duration patience) {
    goals.all().forEach(ClientGoal::cancel);
    return Waiting.until(patience, () -> closed, () -> goals.all().isEmpty());
  }

  @Override
  public void close() {
    closed = true;
    goals.close();
    feedback.close();
    status.close();
    cancelling.close();
    getting.close();
    sending.close();
  }
}
