package org.robotui.ros.action;

import java.time.Duration;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.robotui.message.AnyCodec;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.MessageRegistry;
import org.robotui.message.RecordCodec;
import org.robotui.message.RosValue;
import org.robotui.message.ros.actionlib_msgs.GoalID;
import org.robotui.message.ros.actionlib_msgs.GoalStatusArray;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.Reception;
import org.robotui.ros.RosNode;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;

/** The five topics of an action, from the client's side. */
final class ActionLinks implements ActionClient {

  private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(5);
  private static final AtomicLong COUNTER = new AtomicLong();

  private final RosNode node;
  private final GraphName action;
  private final ActionType type;
  private final DynamicCodec codec;
  private final LiveGoals goals;
  private final Publisher<DynamicMessage> goal;
  private final Publisher<GoalID> cancel;
  private final Subscriber status;
  private final Subscriber feedback;
  private final Subscriber result;
  private volatile boolean closed;

  ActionLinks(RosNode node, GraphName name, ActionType type, MessageRegistry registry, ActionOptions options) {
    this.node = node;
    this.type = type;
    action = node.names().resolve(name.text());
    codec = new DynamicCodec(type.sent());
    goals = new LiveGoals(action.text(), options);
    goal = node.publisher(action + "/goal", codec, PublisherOptions.standard());
    cancel = node.publisher(action + "/cancel", RecordCodec.of(GoalID.class), PublisherOptions.standard());
    SubscriberOptions standard = SubscriberOptions.standard();
    status = node.subscriber(action + "/status", RecordCodec.of(GoalStatusArray.class), standard,
        (array, from) -> goals.statuses(from.callerId(), array.statusList()));
    feedback = node.subscriber(action + "/feedback", new AnyCodec(registry), standard, this::feedback);
    result = node.subscriber(action + "/result", new AnyCodec(registry), standard, this::result);
  }

  private void feedback(DynamicMessage message, Reception from) {
    goals.find(message.text("status.goal_id.id").orElse(""), from.callerId())
        .ifPresent(each -> part(message, "feedback").ifPresent(each::feedback));
  }

  private void result(DynamicMessage message, Reception from) {
    goals.find(message.text("status.goal_id.id").orElse(""), from.callerId()).ifPresent(each -> each.result(
        (int) message.number("status.status").orElse(-1), message.text("status.text").orElse(""),
        part(message, "result")));
  }

  private static Optional<DynamicMessage> part(DynamicMessage message, String field) {
    return message.field(field).filter(RosValue.Nested.class::isInstance)
        .map(value -> ((RosValue.Nested) value).value());
  }

  @Override
  public GraphName name() {
    return action;
  }

  @Override
  public ActionType type() {
    return type;
  }

  @Override
  public Optional<String> server() {
    Set<String> all = new HashSet<>(status.publishers());
    all.retainAll(goal.subscribers());
    all.retainAll(cancel.subscribers());
    all.retainAll(result.publishers());
    return all.stream().sorted().findFirst();
  }

  @Override
  public boolean awaitServer(Duration patience) {
    return await(patience, () -> server().isPresent()) && server().isPresent();
  }

  private boolean await(Duration patience, BooleanSupplier condition) {
    long deadline = System.nanoTime() + patience.toNanos();
    while (!condition.getAsBoolean()) {
      if (closed || System.nanoTime() >= deadline || Thread.currentThread().isInterrupted()) {
        return false;
      }
      LockSupport.parkNanos(LOOK_NANOS);
    }
    return true;
  }

  @Override
  public Outcome<GoalHandle> send(Map<String, ?> values, GoalListener listener, Duration patience) {
    String id = node.name() + "-" + COUNTER.incrementAndGet() + "-" + Long.toUnsignedString(System.nanoTime(), 36);
    try {
      DynamicMessage message = codec.build(wrap(id, values));
      return awaitServer(patience)
          ? server().map(server -> dispatch(id, server, message, listener)).orElseGet(() -> absent(patience))
          : absent(patience);
    } catch (MessageException e) {
      return new Outcome.Refused<>("goal of " + action + ": " + e.getMessage());
    }
  }

  private Map<String, Object> wrap(String id, Map<String, ?> values) {
    long now = node.clock().nowNanos();
    Map<String, Object> message = new LinkedHashMap<>();
    message.put("header", Map.of("stamp", now));
    message.put("goal_id", Map.of("stamp", now, "id", id));
    message.put("goal", values);
    return message;
  }

  private Outcome<GoalHandle> absent(Duration patience) {
    if (closed) {
      return new Outcome.Failed<>("action " + action + ": the client was closed");
    }
    String heard = status.publishers().isEmpty() ? "nobody publishes " + action + "/status"
        : "not all of its links to " + String.join(", ", status.publishers()) + " stand";
    return new Outcome.TimedOut<>("action " + action + " has no server of type " + type.name() + ": " + heard,
        patience);
  }

  /** The goal is tracked before it is sent, so that no answer comes too early. */
  private Outcome<GoalHandle> dispatch(String id, String server, DynamicMessage message, GoalListener listener) {
    TrackedGoal tracked = new TrackedGoal(id, server, listener, cancel::publish, goals::remove);
    if (!goals.add(tracked)) {
      return new Outcome.Refused<>("action " + action + ": too many goals are on their way, or the client was closed");
    }
    goal.publish(message);
    return new Outcome.Done<>(tracked);
  }

  @Override
  public boolean cancelAll(Duration patience) {
    goals.all().forEach(TrackedGoal::cancel);
    return await(patience, () -> goals.all().isEmpty());
  }

  @Override
  public void close() {
    closed = true;
    goals.close();
    status.close();
    feedback.close();
    result.close();
    cancel.close();
    goal.close();
  }
}
