package org.robotui.ros2.internal.action;

import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.robotui.message.DynamicMessage;
import org.robotui.ros2.action.Ros2GoalWorker;

/** A goal that we work on, or did. */
final class ServerGoal implements Ros2GoalWorker.Running {

  private final String id;
  private final long stamp;
  private final Consumer<Map<String, ?>> feedback;
  private final CompletableFuture<DynamicMessage> result = new CompletableFuture<>();
  private volatile int status = GoalStatuses.ACCEPTED;
  private volatile long ended = Long.MAX_VALUE;
  private volatile boolean cancelled;

  ServerGoal(String id, long stamp, Consumer<Map<String, ?>> feedback) {
    this.id = id;
    this.stamp = stamp;
    this.feedback = feedback;
  }

  String id() {
    return id;
  }

  long stamp() {
    return stamp;
  }

  int status() {
    return status;
  }

  boolean live() {
    return status <= GoalStatuses.CANCELING;
  }

  long endedNanos() {
    return ended;
  }

  synchronized void executing() {
    status = cancelled ? GoalStatuses.CANCELING : GoalStatuses.EXECUTING;
  }

  /** Asks for the end; answers whether the goal can still be cancelled. */
  synchronized boolean cancel() {
    if (live()) {
      cancelled = true;
      status = GoalStatuses.CANCELING;
    }
    return live();
  }

  synchronized void end(int number) {
    status = number;
    ended = System.nanoTime();
  }

  CompletableFuture<DynamicMessage> result() {
    return result;
  }

  @Override
  public boolean cancelled() {
    return cancelled;
  }

  @Override
  public void feedback(Map<String, ?> values) {
    feedback.accept(values);
  }
}
