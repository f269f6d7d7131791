package org.robotui.workbench.internal.dock;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.robotui.api.layout.Arrangement;

/** How the views of one RUIC were arranged before, for undo and redo. Display thread only. */
public final class ArrangeHistory {
  private static final int MOST = 100;

  private final Deque<Arrangement> before = new ArrayDeque<>();
  private final Deque<Arrangement> after = new ArrayDeque<>();

  /** The user changes an arrangement: what was undone cannot be redone any more. */
  void changes(Arrangement now) {
    after.clear();
    push(before, now);
  }

  /** The arrangement before the last change; the present one can be redone then. */
  Optional<Arrangement> undo(Arrangement now) {
    return step(before, after, now);
  }

  /** The arrangement before the last undo. */
  Optional<Arrangement> redo(Arrangement now) {
    return step(after, before, now);
  }

  boolean canUndo() {
    return !before.isEmpty();
  }

  boolean canRedo() {
    return !after.isEmpty();
  }

  private static Optional<Arrangement> step(Deque<Arrangement> from, Deque<Arrangement> to, Arrangement now) {
    Optional<Arrangement> next = Optional.ofNullable(from.pollLast());
    next.ifPresent(n -> push(to, now));
    return next;
  }

  private static void push(Deque<Arrangement> stack, Arrangement arrangement) {
    stack.addLast(arrangement);
    if (stack.size() > MOST) {
      stack.removeFirst();
    }
  }
}
