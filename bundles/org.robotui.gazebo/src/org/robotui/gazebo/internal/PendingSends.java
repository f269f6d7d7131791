package org.robotui.gazebo.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;

/** What cannot be sent before a connection is made, and is tried again until it is. For the thread of the loop. */
final class PendingSends {
  private static final int MOST = 1000;

  private final List<Pending> waiting = new ArrayList<>();

  private record Pending(BooleanSupplier attempt, long deadline) {}

  /** Sends now or soon; answers whether there is room for it to wait. */
  boolean send(BooleanSupplier attempt, long deadline) {
    if (attempt.getAsBoolean()) {
      return true;
    }
    return waiting.size() < MOST && waiting.add(new Pending(attempt, deadline));
  }

  /** Tries again; answers whether anything still waits. */
  boolean tick(long now) {
    waiting.removeIf(each -> now - each.deadline() > 0 || each.attempt().getAsBoolean());
    return !waiting.isEmpty();
  }
}
