package org.robotui.ros2.internal.action;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.robotui.net.thread.WatchThread;
import org.robotui.ros2.action.Ros2ActionOptions;

/** The goals on their way, with a thread that runs while there are some and notices that their server is gone. */
final class ClientGoals implements AutoCloseable {

  private static final int LOOKS = 10;

  private final String action;
  private final Ros2ActionOptions options;
  private final BooleanSupplier ready;
  private final Map<String, ClientGoal> goals = new LinkedHashMap<>();
  private final WatchThread watching;
  private volatile long seen;
  private boolean closed;

  ClientGoals(String action, Ros2ActionOptions options, BooleanSupplier ready) {
    this.action = action;
    this.options = options;
    this.ready = ready;
    this.watching =
        new WatchThread(options.threads(), "action " + action, options.silence().dividedBy(LOOKS), this::look);
  }

  /** Takes a goal, unless there are too many or this is closed. */
  synchronized boolean add(ClientGoal goal) {
    if (closed || goals.size() >= options.maxGoals()) {
      return false;
    }
    if (goals.isEmpty()) {
      seen = System.nanoTime();
    }
    goals.put(goal.id(), goal);
    watching.start();
    return true;
  }

  synchronized void remove(ClientGoal goal) {
    goals.remove(goal.id());
    if (goals.isEmpty()) {
      watching.stop();
    }
  }

  synchronized List<ClientGoal> all() {
    return List.copyOf(goals.values());
  }

  synchronized Optional<ClientGoal> find(String id) {
    return Optional.ofNullable(goals.get(id));
  }

  private void look() {
    if (ready.getAsBoolean()) {
      seen = System.nanoTime();
    } else if (System.nanoTime() - seen > options.silence().toNanos()) {
      all().forEach(goal -> goal.lose("the server of " + action + " is gone"));
    }
  }

  @Override
  public void close() {
    synchronized (this) {
      closed = true;
    }
    all().forEach(goal -> goal.lose("the client was closed"));
  }
}
