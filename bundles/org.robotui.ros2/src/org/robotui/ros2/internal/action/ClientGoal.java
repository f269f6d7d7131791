package org.robotui.ros2.internal.action;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.robotui.message.DynamicMessage;
import org.robotui.ros2.action.Ros2GoalEnd;
import org.robotui.ros2.action.Ros2GoalHandle;
import org.robotui.ros2.action.Ros2GoalListener;
import org.robotui.ros2.action.Ros2GoalOutcome;
import org.robotui.ros2.action.Ros2GoalPhase;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One goal on its way. Its lock is held while its listener is called, so that calls come one at a time and in order.
 */
final class ClientGoal implements Ros2GoalHandle {

  private static final Logger LOG = LoggerFactory.getLogger(ClientGoal.class);

  private final String id;
  private final Ros2GoalListener listener;
  private final Consumer<ClientGoal> canceller;
  private final Consumer<ClientGoal> onDone;
  private final ReentrantLock lock = new ReentrantLock();
  private final CompletableFuture<Ros2GoalOutcome> done = new CompletableFuture<>();
  private volatile Ros2GoalPhase phase = Ros2GoalPhase.WAITING_FOR_ACCEPTANCE;
  private volatile long mentioned = System.nanoTime();

  ClientGoal(String id, Ros2GoalListener listener, Consumer<ClientGoal> canceller, Consumer<ClientGoal> onDone) {
    this.id = id;
    this.listener = listener;
    this.canceller = canceller;
    this.onDone = onDone;
  }

  @Override
  public String id() {
    return id;
  }

  @Override
  public Ros2GoalPhase phase() {
    return phase;
  }

  @Override
  public CompletionStage<Ros2GoalOutcome> done() {
    return done.minimalCompletionStage();
  }

  @Override
  public void cancel() {
    if (phase != Ros2GoalPhase.DONE) {
      canceller.accept(this);
    }
  }

  void accepted() {
    enter(Ros2GoalPhase.ACCEPTED);
  }

  /** Takes what the server says of this goal; phases only go on. */
  void status(int status) {
    mentioned = System.nanoTime();
    switch (status) {
      case GoalStatuses.ACCEPTED -> enter(Ros2GoalPhase.ACCEPTED);
      case GoalStatuses.EXECUTING -> enter(Ros2GoalPhase.EXECUTING);
      case GoalStatuses.CANCELING -> enter(Ros2GoalPhase.CANCELING);
      default -> LOG.debug("goal {} has status {}; its result tells the end", id, status);
    }
  }

  long unmentionedNanos() {
    return System.nanoTime() - mentioned;
  }

  void feedback(DynamicMessage feedback) {
    locked(() -> {
      if (phase != Ros2GoalPhase.DONE) {
        tell(() -> listener.onFeedback(feedback));
      }
    });
  }

  void end(Ros2GoalEnd end, String text, Optional<DynamicMessage> result) {
    locked(() -> {
      if (phase != Ros2GoalPhase.DONE) {
        Ros2GoalOutcome outcome = new Ros2GoalOutcome(end, text, result);
        enter(Ros2GoalPhase.DONE);
        onDone.accept(this);
        tell(() -> listener.onDone(outcome));
        done.complete(outcome);
      }
    });
  }

  void lose(String reason) {
    end(Ros2GoalEnd.LOST, reason, Optional.empty());
  }

  private void enter(Ros2GoalPhase next) {
    locked(() -> {
      if (next.compareTo(phase) > 0) {
        phase = next;
        tell(() -> listener.onPhase(next));
      }
    });
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
