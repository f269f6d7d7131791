package org.robotui.uic.parameters.internal.model;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** What was changed, to change it back. All threads. */
final class Undo {
  private static final int MOST = 100;

  private final Deque<Change> changes = new ArrayDeque<>();

  /**
   * A change.
   *
   * @param key the parameter
   * @param before its value before
   */
  record Change(Key key, Object before) {}

  synchronized void push(Change change) {
    changes.push(change);
    if (changes.size() > MOST) {
      changes.removeLast();
    }
  }

  synchronized void drop(Change done) {
    changes.remove(done);
  }

  synchronized Optional<Change> peek() {
    return Optional.ofNullable(changes.peek());
  }
}
