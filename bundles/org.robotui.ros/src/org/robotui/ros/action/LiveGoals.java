package org.robotui.ros.action;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;
import org.robotui.net.thread.WatchThread;

/** The goals on their way, with a thread that runs while there are some and notices that their server is silent. */
final class LiveGoals implements AutoCloseable {

  private final ActionOptions options;
  private final WatchThread watching;
  private final Map<String, TrackedGoal> goals = new LinkedHashMap<>();
  /** When each server spoke last. Only those that goals were sent to. */
  private final Map<String, Long> heard = new LinkedHashMap<>();
  private boolean closed;

  LiveGoals(String action, ActionOptions options) {
    this.options = options;
    this.watching =
        new WatchThread(options.threads(), "action " + action, options.silence().dividedBy(10), this::look);
  }

  /** Takes a goal, unless there are too many or this is closed. */
  synchronized boolean add(TrackedGoal goal) {
    if (closed || goals.size() >= options.maxGoals()) {
      return false;
    }
    goals.put(goal.id(), goal);
    heard.put(goal.server(), System.nanoTime());
    watching.start();
    return true;
  }

  synchronized void remove(TrackedGoal goal) {
    goals.remove(goal.id());
    if (goals.values().stream().noneMatch(other -> other.server().equals(goal.server()))) {
      heard.remove(goal.server());
    }
    if (goals.isEmpty()) {
      watching.stop();
    }
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

  private void look() {
    for (TrackedGoal goal : all()) {
      if (isSilent(goal.server())) {
        goal.lose("server " + goal.server() + " said nothing for " + options.silence().toMillis() + " ms");
      } else {
        goal.expire(options.silence());
      }
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
