package org.robotui.ros2.internal.action;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.robotui.message.DynamicMessage;
import org.robotui.ros2.action.Ros2GoalEnd;
import org.robotui.ros2.action.Ros2GoalTaker;

/** A goal that we work on, or did. */
final class ServerGoal implements Ros2GoalTaker.Taken {

  /** Tells clients; values are maps or messages. */
  interface Voice {
    void changed();

    void feedback(String id, Object values);

    DynamicMessage result(int status, Object values);
  }

  private final String id;
  private final long stamp;
  private final Voice voice;
  private final CompletableFuture<Boolean> decision = new CompletableFuture<>();
  private final CompletableFuture<DynamicMessage> result = new CompletableFuture<>();
  private int status = GoalStatuses.UNDECIDED;
  private boolean cancelled;
  private Optional<Runnable> cancelling = Optional.empty();
  private volatile long ended = Long.MAX_VALUE;

  ServerGoal(String id, long stamp, Voice voice) {
    this.id = id;
    this.stamp = stamp;
    this.voice = voice;
  }

  String id() {
    return id;
  }

  long stamp() {
    return stamp;
  }

  synchronized int status() {
    return status;
  }

  synchronized boolean live() {
    return status <= GoalStatuses.CANCELING;
  }

  long endedNanos() {
    return ended;
  }

  /** Completes with whether it is accepted. */
  CompletableFuture<Boolean> decision() {
    return decision;
  }

  CompletableFuture<DynamicMessage> result() {
    return result;
  }

  @Override
  public void accept() {
    synchronized (this) {
      if (status != GoalStatuses.UNDECIDED) {
        return;
      }
      status = cancelled ? GoalStatuses.CANCELING : GoalStatuses.EXECUTING;
    }
    decision.complete(true);
    voice.changed();
  }

  /** A cancellation that came meanwhile is passed on. */
  void cancelledBy(Runnable way) {
    boolean late;
    synchronized (this) {
      late = cancelled && live();
      cancelling = late ? Optional.empty() : Optional.of(way);
    }
    if (late) {
      way.run();
    }
  }

  /** Asks for the end; answers whether the goal can still be cancelled. */
  boolean cancel() {
    Optional<Runnable> way;
    synchronized (this) {
      if (!live()) {
        return false;
      }
      cancelled = true;
      status = status == GoalStatuses.UNDECIDED ? status : GoalStatuses.CANCELING;
      way = cancelling;
      cancelling = Optional.empty();
    }
    way.ifPresent(Runnable::run);
    return true;
  }

  /** Tells how it gets on. */
  void tell(Object values) {
    accept();
    if (live()) {
      voice.feedback(id, values);
    }
  }

  @Override
  public void feedback(DynamicMessage feedback) {
    tell(feedback);
  }

  @Override
  public void end(Ros2GoalEnd end, Optional<DynamicMessage> value) {
    end(end, value.<Object>map(message -> message).orElse(Map.of()));
  }

  void end(Ros2GoalEnd end, Object values) {
    if (end != Ros2GoalEnd.REJECTED) {
      accept();
    }
    int number;
    synchronized (this) {
      if (!live()) {
        return;
      }
      number = GoalStatuses.of(end);
      status = number;
      ended = System.nanoTime();
    }
    if (decision.complete(false)) {
      return;
    }
    voice.changed();
    result.complete(voice.result(number, values));
  }
}
