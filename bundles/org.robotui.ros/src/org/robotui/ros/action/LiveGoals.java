package org.robotui.ros.action;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;

/** The goals on their way, with a thread that runs while there are some and notices that their server is silent. */
final class LiveGoals implements AutoCloseable {

  private final String action;
  private final ActionOptions options;
  private final Map<String, TrackedGoal> goals = new LinkedHashMap<>();
  /** When each server spoke last. Only those that goals were sent to. */
  private final Map<String, Long> heard = new LinkedHashMap<>();
  private boolean watching;
  private boolean closed;

  LiveGoals(String action, ActionOptions options) {
    this.action = action;
    this.options = options;
  }

  /** Takes a goal, unless there are too many or this is closed. */
  synchronized boolean add(TrackedGoal goal) {
    if (closed || goals.size() >= options.maxGoals()) {
      return false;
    }
    goals.put(goal.id(), goal);
    heard.put(goal.server(), System.nanoTime());
    if (!watching) {
      watching = true;
      Thread thread = options.threads().newThread(this::watch);
      thread.setName("action " + action);
      thread.start();
    }
    return true;
  }

  synchronized void remove(TrackedGoal goal) {
    goals.remove(goal.id());
    if (goals.values().stream().noneMatch(other -> other.server().equals(goal.server()))) {
      heard.remove(goal.server());
    }
    notifyAll();
  }

  synchronized List<TrackedGoal> all() {
    return List.copyOf(goals.values());
  }

  /** A goal, if this node is the one that works on it. */
  synchronized Optional<TrackedGoal> find(String id, String server) {
    return Optional.ofNullable(goals.get(id)).filter(goal -> goal.server().equals(server));
  }

  void statuses(String server, List<GoalStatus> statuses) {
    if (hear(server)) {
      all().stream().filter(goal -> goal.server().equals(server)).forEach(goal -> goal.statuses(statuses));
    }
  }

  private synchronized boolean hear(String server) {
    return heard.replace(server, System.nanoTime()) != null;
  }

  private synchronized boolean isSilent(String server) {
    Long last = heard.get(server);
    return last != null && System.nanoTime() - last > options.silence().toNanos();
  }

  private void watch() {
    while (pause()) {
      for (TrackedGoal goal : all()) {
        if (isSilent(goal.server())) {
          goal.lose("server " + goal.server() + " said nothing for " + options.silence().toMillis() + " ms");
        } else {
          goal.expire(options.silence());
        }
      }
    }
  }

  /** Waits a little; answers whether there is still something to watch. */
  private synchronized boolean pause() {
    Duration step = options.silence().dividedBy(10);
    long until = System.nanoTime() + step.toNanos();
    try {
      for (long left = step.toNanos(); !goals.isEmpty() && left > 0; left = until - System.nanoTime()) {
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
