package org.robotui.ros2.internal.action;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ThreadFactory;
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
import org.robotui.ros2.action.Ros2GoalWorker;
import org.robotui.ros2.internal.msgs.CancelGoalAsk;
import org.robotui.ros2.internal.msgs.CancelGoalReply;
import org.robotui.ros2.internal.msgs.WireGoalInfo;
import org.robotui.ros2.internal.msgs.WireGoalStatus;
import org.robotui.ros2.internal.msgs.WireGoalStatusArray;
import org.robotui.ros2.name.Ros2Name;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The three services and two topics of an action, from the server's side. */
public final class ActionServerLinks implements Ros2ActionServer {

  private static final Logger LOG = LoggerFactory.getLogger(ActionServerLinks.class);
  private static final int MOST_GOALS = 100;
  private static final String NO_ID = "0".repeat(2 * GoalIds.BYTES);
  /** How long results of goals that ended are there for who asks late. */
  private static final Duration KEPT = Duration.ofSeconds(10);
  private static final int ERROR_REJECTED = 1;
  private static final int ERROR_UNKNOWN = 2;

  private final Ros2Node node;
  private final Ros2Name name;
  private final ThreadFactory threads;
  private final Ros2GoalWorker worker;
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
   * @param threads makes one thread for each goal
   * @param worker works on goals
   */
  public ActionServerLinks(Ros2Node node, String action, TypedAction type, ThreadFactory threads,
      Ros2GoalWorker worker) {
    this.node = node;
    this.name = node.names().service(action);
    this.threads = threads;
    this.worker = worker;
    sent = new DynamicCodec(type.schema().sendGoal().response());
    got = new DynamicCodec(type.schema().getResult().response());
    told = new DynamicCodec(type.schema().feedbackMessage());
    ActionNames names = new ActionNames(name, type);
    feedback = node.publisher(names.feedback(), names.telling(), QosProfiles.DEFAULT);
    status = node.publisher(names.status(), Ros2Codec.of(WireGoalStatusArray.class), QosProfiles.LATCHED);
    services.add(node.serviceServer(names.sendGoal(), names.sending(), (request, caller) -> take(request)));
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

  private DynamicMessage take(DynamicMessage request) {
    String id = GoalIds.of(request).orElse(NO_ID);
    DynamicMessage wanted = GoalIds.inner(request, "goal").orElseThrow();
    long now = node.clock().nowNanos();
    ServerGoal goal = new ServerGoal(id, now, values -> tell(id, values));
    boolean accepted = worker.accept(wanted) && add(goal);
    if (accepted) {
      Thread thread = threads.newThread(() -> work(goal, wanted));
      thread.setName("goal of " + name);
      thread.start();
    }
    return build(sent, Map.of("accepted", accepted, "stamp", now));
  }

  private synchronized boolean add(ServerGoal goal) {
    long now = System.nanoTime();
    goals.values().removeIf(each -> !each.live() && now - each.endedNanos() > KEPT.toNanos());
    return goals.size() < MOST_GOALS && goals.putIfAbsent(goal.id(), goal) == null;
  }

  private void tell(String id, Map<String, ?> values) {
    feedback.publish(build(told, Map.of("goal_id", Map.of("uuid", GoalIds.bytes(id)), "feedback", values)));
  }

  private void work(ServerGoal goal, DynamicMessage wanted) {
    goal.executing();
    publish();
    Ros2GoalWorker.End end = new Ros2GoalWorker.End(Ros2GoalEnd.ABORTED, Map.of());
    try {
      end = worker.work(wanted, goal);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (RuntimeException e) {
      LOG.error("work on a goal of {} failed", name, e);
    }
    int number = GoalStatuses.of(end.end());
    goal.end(number);
    publish();
    goal.result().complete(build(got, Map.of("status", number, "result", end.result())));
  }

  private synchronized void publish() {
    status.publish(new WireGoalStatusArray(goals.values().stream()
        .map(goal -> new WireGoalStatus(new WireGoalInfo(GoalIds.wire(goal.id()), goal.stamp()), goal.status()))
        .toList()));
  }

  /** A goal that is not known has status 0. */
  private synchronized CompletionStage<DynamicMessage> result(DynamicMessage request) {
    ServerGoal goal = GoalIds.of(request).map(goals::get).orElse(null);
    return goal == null ? CompletableFuture.completedStage(build(got, Map.of("status", 0)))
        : goal.result().minimalCompletionStage();
  }

  /** Without an identifier all goals are meant, with a time those that were taken until then. */
  private CancelGoalReply cancel(CancelGoalAsk ask) {
    String id = GoalIds.text(ask.goalInfo().goalId().uuid());
    long until = ask.goalInfo().stamp();
    List<ServerGoal> meant = meant(id, until);
    List<WireGoalInfo> ending = meant.stream().filter(ServerGoal::cancel)
        .map(goal -> new WireGoalInfo(GoalIds.wire(goal.id()), goal.stamp())).toList();
    publish();
    boolean unknown = meant.isEmpty() && !id.equals(NO_ID);
    return new CancelGoalReply(unknown ? ERROR_UNKNOWN : ending.isEmpty() ? ERROR_REJECTED : 0, ending);
  }

  private synchronized List<ServerGoal> meant(String id, long until) {
    return goals.values().stream().filter(goal -> goal.id().equals(id)
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
