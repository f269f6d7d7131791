package org.robotui.message.topic;

import java.time.Duration;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;

/**
 * Sends goals to actions. A route to an action is open only while a goal of ours is under way. A call that is cancelled
 * cancels its goal and waits a moment for the robot to say how it ended. Safe for all threads.
 */
public final class ActionCalls implements CallHandler<ActionRequest, ActionReply>, AutoCloseable {
  private static final Duration PATIENCE = Duration.ofSeconds(5);
  private static final Duration LAST_WORD = Duration.ofMillis(2500);
  private static final Duration AT_THE_END = Duration.ofMillis(300);

  /** The names of the phases in which robots work on goals, in ROS 1 and ROS 2. */
  private static final Set<String> WORK = Set.of("active", "executing");

  private final ActionRoute.Opener opener;
  private final Map<String, Shared> routes = new HashMap<>();

  /** A route and how many goals of ours need it. */
  private static final class Shared {
    private final ActionRoute route;
    private int goals;

    Shared(ActionRoute route) {
      this.route = route;
    }
  }

  /**
   * Has no routes yet.
   *
   * @param opener opens them
   */
  public ActionCalls(ActionRoute.Opener opener) {
    this.opener = opener;
  }

  /**
   * Tells how far a goal got.
   *
   * @param told hears it
   * @param phase the phase of the goal
   * @param text what the robot says of it, may be empty
   */
  public static void tell(Invocation<ActionRequest> told, Enum<?> phase, String text) {
    String word = phase.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    told.progress(Double.NaN, text.isEmpty() ? word : word + ": " + text);
  }

  /** Whether a word that was told so says that the robot works on the goal. */
  static boolean isAtWork(String told) {
    int colon = told.indexOf(':');
    return WORK.contains(colon < 0 ? told : told.substring(0, colon));
  }

  @Override
  public ActionReply handle(Invocation<ActionRequest> invocation) throws CallException, InterruptedException {
    String action = invocation.request().action();
    ActionRoute route = borrow(action);
    try {
      return await(route.send(invocation.request().goal(), invocation, PATIENCE), invocation.deadlineNanos());
    } finally {
      giveBack(action);
    }
  }

  private static ActionReply await(ActionRoute.Underway goal, long deadlineNanos)
      throws CallException, InterruptedException {
    CompletableFuture<ActionReply> done = goal.done().toCompletableFuture();
    try {
      return done.get(Math.max(1, deadlineNanos - System.nanoTime()), TimeUnit.NANOSECONDS);
    } catch (InterruptedException | TimeoutException e) {
      goal.cancel();
      return lastWord(done);
    } catch (ExecutionException e) {
      throw new CallException("the goal was lost: " + e.getCause(), e);
    }
  }

  private static ActionReply lastWord(CompletableFuture<ActionReply> done) throws CallException, InterruptedException {
    try {
      return done.get(LAST_WORD.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException | ExecutionException e) {
      throw new CallException("the goal was cancelled; the robot has not said how it ended", e);
    }
  }

  /** Opening may ask the robot, which must not hold up the others. */
  private ActionRoute borrow(String action) throws CallException {
    Optional<ActionRoute> open = share(action, Optional.empty());
    if (open.isPresent()) {
      return open.get();
    }
    ActionRoute made = opener.open(action);
    ActionRoute used = share(action, Optional.of(made)).orElse(made);
    if (used != made) {
      made.close();
    }
    return used;
  }

  private Optional<ActionRoute> share(String action, Optional<ActionRoute> made) {
    synchronized (routes) {
      made.ifPresent(route -> routes.putIfAbsent(action, new Shared(route)));
      Optional<Shared> shared = Optional.ofNullable(routes.get(action));
      shared.ifPresent(s -> s.goals++);
      return shared.map(s -> s.route);
    }
  }

  private void giveBack(String action) {
    synchronized (routes) {
      Shared shared = routes.get(action);
      if (shared != null && --shared.goals == 0) {
        routes.remove(action);
        shared.route.close();
      }
    }
  }

  /** Cancels what is under way: a robot does not go on with what nobody looks at any more. */
  @Override
  public void close() {
    synchronized (routes) {
      routes.values().forEach(shared -> {
        shared.route.cancelAll(AT_THE_END);
        shared.route.close();
      });
      routes.clear();
    }
  }
}
