package org.robotui.rfic.ros.internal.call;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageRegistry;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.MessageRecord;
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
 * Sends goals to actions. The topics of an action are ours only while a goal of ours is under way. A call that is
 * cancelled cancels its goal and waits a moment for the server to say how it ended.
 */
public final class RosActions implements CallHandler<ActionRequest, ActionReply>, AutoCloseable {
  private static final Duration PATIENCE = Duration.ofSeconds(5);
  private static final Duration LAST_WORD = Duration.ofMillis(2500);
  private static final Duration AT_THE_END = Duration.ofMillis(300);

  private final RosNode node;
  private final MessageRegistry registry;
  private final ThreadFactory threads;
  private final Map<String, Client> clients = new HashMap<>();

  /** A client and how many goals of ours need it. */
  private static final class Client {
    private final ActionClient client;
    private int goals;

    Client(ActionClient client) {
      this.client = client;
    }
  }

  /**
   * Creates a caller.
   *
   * @param node sends
   * @param registry knows the definitions
   * @param threads makes the threads that notice the loss of servers
   */
  public RosActions(RosNode node, MessageRegistry registry, ThreadFactory threads) {
    this.node = node;
    this.registry = registry;
    this.threads = threads;
  }

  @Override
  public ActionReply handle(Invocation<ActionRequest> invocation) throws CallException, InterruptedException {
    String action = invocation.request().action();
    ActionClient client = borrow(action);
    try {
      GoalHandle goal = Outcomes.value(client.send(invocation.request().goal(), told(invocation), PATIENCE));
      return reply(await(goal, invocation.deadlineNanos()));
    } finally {
      giveBack(action);
    }
  }

  private static GoalListener told(Invocation<ActionRequest> invocation) {
    return new GoalListener() {
      @Override
      public void onPhase(GoalPhase phase, String text) {
        String word = phase.name().toLowerCase(Locale.ROOT).replace('_', ' ');
        invocation.progress(Double.NaN, text.isEmpty() ? word : word + ": " + text);
      }

      @Override
      public void onFeedback(DynamicMessage feedback) {
        invocation.feedback(new MessageRecord(feedback));
      }
    };
  }

  private static GoalOutcome await(GoalHandle goal, long deadlineNanos) throws CallException, InterruptedException {
    CompletableFuture<GoalOutcome> done = goal.done().toCompletableFuture();
    try {
      return done.get(Math.max(1, deadlineNanos - System.nanoTime()), TimeUnit.NANOSECONDS);
    } catch (InterruptedException | TimeoutException e) {
      goal.cancel();
      return lastWord(done);
    } catch (ExecutionException e) {
      throw new CallException("the goal was lost: " + e.getCause(), e);
    }
  }

  private static GoalOutcome lastWord(CompletableFuture<GoalOutcome> done) throws CallException, InterruptedException {
    try {
      return done.get(LAST_WORD.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException | ExecutionException e) {
      throw new CallException("the goal was cancelled; the robot has not said how it ended", e);
    }
  }

  private static ActionReply reply(GoalOutcome outcome) {
    return new ActionReply(ActionReply.End.valueOf(outcome.end().name()), outcome.text(),
        outcome.result().<DynamicRecord>map(MessageRecord::new));
  }

  private ActionClient borrow(String action) throws CallException {
    ActionType type = type(action);
    synchronized (clients) {
      Client client = clients.computeIfAbsent(action, name -> new Client(
          ActionClient.open(node, GraphName.of(name), type, registry, ActionOptions.standard(threads))));
      client.goals++;
      return client.client;
    }
  }

  private ActionType type(String action) throws CallException {
    List<ActionInfo> all = Outcomes.value(Actions.list(node.master()));
    ActionInfo info = all.stream().filter(a -> a.name().text().equals(action)).findFirst()
        .orElseThrow(() -> new CallException("nobody serves the action " + action));
    return switch (ActionType.find(info.type(), registry)) {
      case SchemaLookup.Found<ActionType> f -> f.schema();
      case SchemaLookup.Missing<ActionType> m -> throw new CallException(m.reason());
    };
  }

  private void giveBack(String action) {
    synchronized (clients) {
      Client client = clients.get(action);
      if (client != null && --client.goals == 0) {
        clients.remove(action);
        client.client.close();
      }
    }
  }

  /** Cancels what is under way: a robot does not go on with what nobody looks at any more. */
  @Override
  public void close() {
    synchronized (clients) {
      clients.values().forEach(c -> {
        c.client.cancelAll(AT_THE_END);
        c.client.close();
      });
      clients.clear();
    }
  }
}
