package org.robotui.ros.action;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.RecordCodec;
import org.robotui.message.RosValue;
import org.robotui.message.ros.actionlib_msgs.GoalID;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;
import org.robotui.message.ros.actionlib_msgs.GoalStatusArray;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.ros.GraphName;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.Reception;
import org.robotui.ros.RosNode;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The five topics of an action, from the server's side. */
final class ActionServerTopics implements ActionServer, ServedGoal.Voice {

  private static final Logger LOG = LoggerFactory.getLogger(ActionServerTopics.class);
  private static final long KEPT = TimeUnit.SECONDS.toNanos(MENTIONED_SECONDS);
  private static final long PACE = TimeUnit.MILLISECONDS.toNanos(180);
  private static final int MOST_GOALS = 100;
  private static final int MOST_EARLY = 50;

  private final RosNode node;
  private final GraphName action;
  private final GoalTaker taker;
  private final DynamicCodec results;
  private final DynamicCodec feedbacks;
  private final Publisher<GoalStatusArray> status;
  private final Publisher<DynamicMessage> feedback;
  private final Publisher<DynamicMessage> result;
  private final Subscriber goal;
  private final Subscriber cancel;
  private final Map<String, ServedGoal> goals = new LinkedHashMap<>();
  /** Goals whose cancellation came before them, as both have links of their own. */
  private final Set<String> early = new LinkedHashSet<>();
  private long unnamed;
  private long due = System.nanoTime();

  ActionServerTopics(RosNode node, GraphName name, ActionWire type, GoalTaker taker) {
    this.node = node;
    this.taker = taker;
    action = node.names().resolve(name.text());
    results = new DynamicCodec(type.result());
    feedbacks = new DynamicCodec(type.feedback());
    PublisherOptions standard = PublisherOptions.standard();
    status = node.publisher(action + "/status", RecordCodec.of(GoalStatusArray.class), standard);
    feedback = node.publisher(action + "/feedback", feedbacks, standard);
    result = node.publisher(action + "/result", results, standard);
    cancel = node.subscriber(action + "/cancel", RecordCodec.of(GoalID.class), SubscriberOptions.standard(),
        (wish, from) -> cancel(wish));
    goal = node.subscriber(action + "/goal", new DynamicCodec(type.type().sent()), SubscriberOptions.standard(),
        this::take);
  }

  @Override
  public GraphName name() {
    return action;
  }

  private void take(DynamicMessage message, Reception from) {
    Optional<ServedGoal> added = add(named(message));
    if (added.isEmpty()) {
      return;
    }
    ServedGoal served = added.get();
    changed();
    if (isEarly(served.id().id())) {
      served.end(GoalEnd.RECALLED, "was cancelled before it came", Optional.empty());
      return;
    }
    try {
      served.cancelledBy(taker.take(part(message, "goal"), from.callerId(), served));
    } catch (RuntimeException e) {
      LOG.error("a goal of {} could not be begun with", action, e);
      served.end(GoalEnd.REJECTED, "the server failed: " + e.getMessage(), Optional.empty());
    }
  }

  private static DynamicMessage part(DynamicMessage message, String field) {
    return message.field(field).filter(RosValue.Nested.class::isInstance)
        .map(value -> ((RosValue.Nested) value).value()).orElseThrow();
  }

  private GoalID named(DynamicMessage message) {
    DynamicMessage id = part(message, "goal_id");
    long stamp = id.field("stamp").orElse(null) instanceof RosValue.Instant time ? time.nanos() : 0;
    String name = id.text("id").orElse("");
    return new GoalID(stamp == 0 ? node.clock().nowNanos() : stamp, name.isEmpty() ? made() : name);
  }

  private synchronized String made() {
    unnamed++;
    return node.name() + "-" + action + "-" + unnamed;
  }

  /** Nothing where it is known already, or where too many are. */
  private synchronized Optional<ServedGoal> add(GoalID id) {
    forget();
    ServedGoal served = new ServedGoal(id, this);
    return goals.size() < MOST_GOALS && goals.putIfAbsent(id.id(), served) == null ? Optional.of(served)
        : Optional.empty();
  }

  private synchronized boolean isEarly(String id) {
    return early.remove(id);
  }

  private void forget() {
    long now = System.nanoTime();
    goals.values().removeIf(each -> each.isOver() && now - each.endedNanos() > KEPT);
  }

  /** Without a name all are meant, with a time those that were sent until then. */
  private void cancel(GoalID wish) {
    List<ServedGoal> meant;
    synchronized (this) {
      boolean all = wish.id().isEmpty() && wish.stamp() == 0;
      meant = goals.values().stream().filter(each -> all || each.id().id().equals(wish.id())
          || wish.stamp() != 0 && each.id().stamp() <= wish.stamp()).toList();
      if (!wish.id().isEmpty() && !goals.containsKey(wish.id()) && early.size() < MOST_EARLY) {
        early.add(wish.id());
      }
    }
    meant.forEach(ServedGoal::cancel);
  }

  @Override
  public void tick() {
    synchronized (this) {
      long now = System.nanoTime();
      if (now - due < 0) {
        return;
      }
      due = now + PACE;
      forget();
    }
    changed();
  }

  @Override
  public void changed() {
    status.publish(new GoalStatusArray(new Header(0, node.clock().nowNanos(), ""), messages()));
  }

  private synchronized List<GoalStatus> messages() {
    return goals.values().stream().map(ServedGoal::message).toList();
  }

  @Override
  public void feedback(GoalStatus now, DynamicMessage value) {
    feedback.publish(wrapped(feedbacks, now, Map.of("feedback", value)));
  }

  @Override
  public void result(GoalStatus now, Optional<DynamicMessage> value) {
    result.publish(wrapped(results, now, value.<Map<String, Object>>map(v -> Map.of("result", v)).orElse(Map.of())));
    changed();
  }

  private DynamicMessage wrapped(DynamicCodec codec, GoalStatus now, Map<String, Object> inner) {
    Map<String, Object> message = new LinkedHashMap<>(inner);
    message.put("header", Map.of("stamp", node.clock().nowNanos()));
    message.put("status", Map.of("goal_id", Map.of("stamp", now.goalId().stamp(), "id", now.goalId().id()), "status",
        now.status(), "text", now.text()));
    try {
      return codec.build(message);
    } catch (MessageException e) {
      throw new IllegalArgumentException("action " + action + ": " + e.getMessage(), e);
    }
  }

  @Override
  public void close() {
    goal.close();
    cancel.close();
    List<ServedGoal> left;
    synchronized (this) {
      left = List.copyOf(goals.values());
    }
    left.forEach(ServedGoal::cancel);
    status.close();
    feedback.close();
    result.close();
  }
}
