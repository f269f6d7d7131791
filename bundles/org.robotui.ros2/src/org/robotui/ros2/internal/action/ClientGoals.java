package org.robotui.ros2.internal.action;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.robotui.ros2.action.Ros2ActionOptions;

/** The goals on their way, with a thread that runs while there are some and notices that their server is gone. */
final class ClientGoals implements AutoCloseable {

  private static final int LOOKS = 10;

  private final String action;
  private final Ros2ActionOptions options;
  private final BooleanSupplier ready;
  private final Map<String, ClientGoal> goals = new LinkedHashMap<>();
  private boolean watching;
  private boolean closed;

  ClientGoals(String action, Ros2ActionOptions options, BooleanSupplier ready) {
    this.action = action;
    this.options = options;
    this.ready = ready;
  }

  /** Takes a goal, unless there are too many or this is closed. */
  synchronized boolean add(ClientGoal goal) {
    if (closed || goals.size() >= options.maxGoals()) {
      return false;
    }
    goals.put(goal.id(), goal);
    if (!watching) {
      watching = true;
      Thread thread = options.threads().newThread(this::watch);
      thread.setName("action " + action);
      thread.start();
    }
    return true;
  }

  synchronized void remove(ClientGoal goal) {
    goals.remove(goal.id());
    notifyAll();
  }

  synchronized List<ClientGoal> all() {
    return List.copyOf(goals.values());
  }

  synchronized Optional<ClientGoal> find(String id) {
    return Optional.ofNullable(goals.get(id));
  }

  private void watch() {
    long seen = System.nanoTime();
    while (pause()) {
      if (ready.getAsBoolean()) {
        seen = System.nanoTime();
      } else if (System.nanoTime() - seen > options.silence().toNanos()) {
        all().forEach(goal -> goal.lose("the server of " + action + " is gone"));
      }
    }
  }

  /** Waits a little; answers whether there is still something to watch. */
  private synchronized boolean pause() {
    long step = options.silence().toNanos() / LOOKS;
    long until = System.nanoTime() + step;
    try {
      for (long left = step; !goals.isEmpty() && left > 0; left = until - System.nanoTime()) {
        TimeUnit.NANOSECONDS.timedWait(this, left);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      watching = false;
      return false;
    }
    watching = !goals.isEmpty();
    return watching;
  }

  @Override
  public void close() {
    synchronized (this) {
      closed = true;
    }
    all().forEach(goal -> goal.lose("the client was closed"));
  }
}
