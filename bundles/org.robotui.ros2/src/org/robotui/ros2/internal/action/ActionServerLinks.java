package org.robotui.ros2.internal.action;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Publisher;
import org.robotui.ros2.Ros2ServiceServer;
import org.robotui.ros2.Ros2Types.TypedAction;
import org.robotui.ros2.action.Ros2ActionServer;
import org.robotui.ros2.action.Ros2GoalEnd;
import org.robotui.ros2.action.Ros2GoalTaker;
import org.robotui.ros2.internal.msgs.CancelGoalAsk;
import org.robotui.ros2.internal.msgs.CancelGoalReply;
import org.robotui.ros2.internal.msgs.WireGoalInfo;
import org.robotui.ros2.internal.msgs.WireGoalStatus;
import org.robotui.ros2.internal.msgs.WireGoalStatusArray;
import org.robotui.ros2.name.Ros2Name;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The three services and two topics of an action, from the server's side. */
public final class ActionServerLinks implements Ros2ActionServer, ServerGoal.Voice {

  private static final Logger LOG = LoggerFactory.getLogger(ActionServerLinks.class);
  private static final int MOST_GOALS = 100;
  private static final String NO_ID = "0".repeat(2 * GoalIds.BYTES);
  /** How long results of goals that ended are there for who asks late. */
  private static final Duration KEPT = Duration.ofSeconds(10);
  private static final int ERROR_REJECTED = 1;
  private static final int ERROR_UNKNOWN = 2;

  private final Ros2Node node;
  private final Ros2Name name;
  private final Ros2GoalTaker taker;
  private final DynamicCodec sent;
  private final DynamicCodec got;
  private final DynamicCodec told;
  private final Ros2Publisher<DynamicMessage> feedback;
  private final Ros2Publisher<WireGoalStatusArray> status;
  private final List<Ros2ServiceServer> services = new ArrayList<>();
  private final Map<String, ServerGoal> goals = new LinkedHashMap<>();

  /**
   * Offers it.
   *
   * @param node the node
   * @param action the action's name
   * @param type the action's type
   * @param taker works on goals
   */
  public ActionServerLinks(Ros2Node node, String action, TypedAction type, Ros2GoalTaker taker) {
    this.node = node;
    this.name = node.names().service(action);
    this.taker = taker;
    sent = new DynamicCodec(type.schema().sendGoal().response());
    got = new DynamicCodec(type.schema().getResult().response());
    told = new DynamicCodec(type.schema().feedbackMessage());
    ActionNames names = new ActionNames(name, type);
    feedback = node.publisher(names.feedback(), names.telling(), QosProfiles.DEFAULT);
    status = node.publisher(names.status(), Ros2Codec.of(WireGoalStatusArray.class), QosProfiles.LATCHED);
    services.add(node.deferringServer(names.sendGoal(), names.sending(), QosProfiles.SERVICES,
        (request, caller) -> take(request)));
    services.add(node.deferringServer(names.getResult(), names.getting(), QosProfiles.SERVICES,
        (request, caller) -> result(request)));
    services
        .add(node.serviceServer(names.cancelGoal(), ActionNames.cancelling(), (request, caller) -> cancel(request)));
  }

  @Override
  public Ros2Name name() {
    return name;
  }

  private DynamicMessage build(DynamicCodec codec, Map<String, ?> values) {
    try {
      return codec.build(values);
    } catch (MessageException e) {
      throw new IllegalArgumentException("action " + name + ": " + e.getMessage(), e);
    }
  }

  private CompletionStage<DynamicMessage> take(DynamicMessage request) {
    String id = GoalIds.of(request).orElse(NO_ID);
    DynamicMessage wanted = GoalIds.inner(request, "goal").orElseThrow();
    long now = node.clock().nowNanos();
    ServerGoal goal = new ServerGoal(id, now, this);
    if (!add(goal)) {
      return CompletableFuture.completedStage(build(sent, Map.of("accepted", false, "stamp", now)));
    }
    begin(goal, wanted);
    return goal.decision().thenApply(accepted -> build(sent, Map.of("accepted", accepted, "stamp", now)));
  }

  private void begin(ServerGoal goal, DynamicMessage wanted) {
    try {
      goal.cancelledBy(taker.take(wanted, goal));
    } catch (RuntimeException e) {
      LOG.error("a goal of {} could not be begun with", name, e);
      goal.end(Ros2GoalEnd.REJECTED, Map.of());
    }
  }

  private synchronized boolean add(ServerGoal goal) {
    long now = System.nanoTime();
    goals.values().removeIf(each -> !each.live() && now - each.endedNanos() > KEPT.toNanos());
    return goals.size() < MOST_GOALS && goals.putIfAbsent(goal.id(), goal) == null;
  }

  @Override
  public void feedback(String id, Object values) {
    feedback.publish(build(told, Map.of("goal_id", Map.of("uuid", GoalIds.bytes(id)), "feedback", values)));
  }

  @Override
  public DynamicMessage result(int number, Object values) {
    return build(got, Map.of("status", number, "result", values));
  }

  @Override
  public void changed() {
    synchronized (status) {
      status.publish(new WireGoalStatusArray(accepted().stream()
          .map(goal -> new WireGoalStatus(new WireGoalInfo(GoalIds.wire(goal.id()), goal.stamp()), goal.status()))
          .toList()));
    }
  }

  /** Those of which their clients know that they are accepted. */
  private synchronized List<ServerGoal> accepted() {
    return goals.values().stream().filter(goal -> goal.decision().getNow(false)).toList();
  }

  /** A goal that is not known has status 0. */
  private synchronized CompletionStage<DynamicMessage> result(DynamicMessage request) {
    ServerGoal goal = GoalIds.of(request).map(goals::get).orElse(null);
    return goal == null || !goal.decision().getNow(false)
        ? CompletableFuture.completedStage(build(got, Map.of("status", 0)))
        : goal.result().minimalCompletionStage();
  }

  /** Without an identifier all goals are meant, with a time those that were taken until then. */
  private CancelGoalReply cancel(CancelGoalAsk ask) {
    String id = GoalIds.text(ask.goalInfo().goalId().uuid());
    long until = ask.goalInfo().stamp();
    List<ServerGoal> meant = meant(id, until);
    List<WireGoalInfo> ending = meant.stream().filter(ServerGoal::cancel)
        .map(goal -> new WireGoalInfo(GoalIds.wire(goal.id()), goal.stamp())).toList();
    changed();
    boolean unknown = meant.isEmpty() && !id.equals(NO_ID);
    return new CancelGoalReply(unknown ? ERROR_UNKNOWN : ending.isEmpty() ? ERROR_REJECTED : 0, ending);
  }

  private synchronized List<ServerGoal> meant(String id, long until) {
    return accepted().stream().filter(goal -> goal.id().equals(id)
        || id.equals(NO_ID) && until == 0 || until > 0 && goal.stamp() <= until).toList();
  }

  @Override
  public void close() {
    services.forEach(Ros2ServiceServer::close);
    List<ServerGoal> left;
    synchronized (this) {
      left = List.copyOf(goals.values());
    }
    left.forEach(ServerGoal::cancel);
    feedback.close();
    status.close();
  }
}
