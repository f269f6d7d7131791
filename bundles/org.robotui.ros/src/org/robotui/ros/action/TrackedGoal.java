package org.robotui.ros.action;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.robotui.message.DynamicMessage;
import org.robotui.message.ros.actionlib_msgs.GoalID;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One goal on its way. Its lock is held while its listener is called, so that calls come one at a time and in order.
 */
final class TrackedGoal implements GoalHandle {

  private static final Logger LOG = LoggerFactory.getLogger(TrackedGoal.class);

  private final String id;
  private final String server;
  private final GoalListener listener;
  private final Consumer<GoalID> canceller;
  private final Consumer<TrackedGoal> onDone;
  private final ReentrantLock lock = new ReentrantLock();
  private final CompletableFuture<GoalOutcome> done = new CompletableFuture<>();
  private volatile GoalPhase phase = GoalPhase.WAITING_FOR_ACKNOWLEDGEMENT;
  private long phaseSince = System.nanoTime();
  private String text = "";
  private boolean acknowledged;
  private Optional<GoalEnd> announced = Optional.empty();

  TrackedGoal(String id, String server, GoalListener listener, Consumer<GoalID> canceller,
      Consumer<TrackedGoal> onDone) {
    this.id = id;
    this.server = server;
    this.listener = listener;
    this.canceller = canceller;
    this.onDone = onDone;
  }

  @Override
  public String id() {
    return id;
  }

  /** The node the goal was sent to. */
  String server() {
    return server;
  }

  @Override
  public GoalPhase phase() {
    return phase;
  }

  @Override
  public CompletionStage<GoalOutcome> done() {
    return done.minimalCompletionStage();
  }

  @Override
  public void cancel() {
    locked(() -> {
      boolean useful = phase.compareTo(GoalPhase.WAITING_FOR_CANCEL) < 0;
      if (phase.compareTo(GoalPhase.WAITING_FOR_RESULT) < 0) {
        canceller.accept(new GoalID(0, id));
      }
      if (useful) {
        enter(GoalPhase.WAITING_FOR_CANCEL);
      }
    });
  }

  /** Takes what the server says about all its goals. */
  void statuses(List<GoalStatus> all) {
    locked(() -> all.stream().filter(status -> status.goalId().id().equals(id)).findFirst()
        .ifPresentOrElse(this::status, this::unmentioned));
  }

  private void status(GoalStatus status) {
    if (phase == GoalPhase.DONE) {
      return;
    }
    Optional<List<GoalPhase>> steps = Transitions.next(phase, status.status());
    if (steps.isEmpty()) {
      LOG.debug("goal {} is {}: {} reports status {}, which does not follow", id, phase, server, status.status());
      return;
    }
    text = status.text();
    acknowledged = true;
    announced = GoalEnd.of(status.status()).or(() -> announced);
    steps.get().forEach(this::enter);
  }

  /**
   * Before it was mentioned once, a goal may still be on its way, and once it ended the server may forget it before us.
   */
  private void unmentioned() {
    if (acknowledged && phase != GoalPhase.WAITING_FOR_RESULT) {
      end(GoalOutcome.lost("server " + server + " does not know the goal any more"));
    }
  }

  /** Takes the result, which ends the goal whatever came before. */
  void result(int status, String words, Optional<DynamicMessage> result) {
    locked(() -> {
      Transitions.next(phase, status).ifPresent(steps -> steps.forEach(this::enter));
      end(GoalEnd.of(status).map(end -> new GoalOutcome(end, words, result))
          .orElseGet(() -> new GoalOutcome(GoalEnd.LOST,
              "server " + server + " sent a result with status " + status + ", which is no end", result)));
    });
  }

  void feedback(DynamicMessage feedback) {
    locked(() -> {
      if (phase != GoalPhase.DONE) {
        tell(() -> listener.onFeedback(feedback));
      }
    });
  }

  /** Ends a goal about which the server says no more: it did not take it, or its result does not come. */
  void expire(Duration patience) {
    locked(() -> {
      boolean late = System.nanoTime() - phaseSince > patience.toNanos();
      if (late && !acknowledged && phase != GoalPhase.WAITING_FOR_RESULT) {
        end(GoalOutcome
            .lost("server " + server + " did not acknowledge the goal within " + patience.toMillis() + " ms"));
      } else if (late && phase == GoalPhase.WAITING_FOR_RESULT) {
        end(new GoalOutcome(announced.orElse(GoalEnd.LOST), text, Optional.empty()));
      }
    });
  }

  void lose(String reason) {
    locked(() -> end(GoalOutcome.lost(reason)));
  }

  private void end(GoalOutcome outcome) {
    if (phase != GoalPhase.DONE) {
      text = outcome.text();
      enter(GoalPhase.DONE);
      onDone.accept(this);
      tell(() -> listener.onDone(outcome));
      done.complete(outcome);
    }
  }

  private void enter(GoalPhase next) {
    if (phase != GoalPhase.DONE) {
      phase = next;
      phaseSince = System.nanoTime();
      String words = text;
      tell(() -> listener.onPhase(next, words));
    }
  }

  private void tell(Runnable call) {
    try {
      call.run();
    } catch (RuntimeException e) {
      LOG.error("listener of goal {} failed", id, e);
    }
  }

  private void locked(Runnable work) {
    lock.lock();
    try {
      work.run();
    } finally {
      lock.unlock();
    }
  }
}
