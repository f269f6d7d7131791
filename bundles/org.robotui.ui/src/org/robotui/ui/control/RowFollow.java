package org.robotui.ui.control;

import java.util.function.Consumer;

/** Whether the end of a list stays in sight. */
final class RowFollow {
  private Consumer<Boolean> changed = on -> {};
  private boolean possible;
  private boolean now;

  /** From now on it does, until it is told otherwise. */
  void begin(Consumer<Boolean> listener) {
    changed = listener;
    possible = true;
    now = true;
  }

  boolean now() {
    return now;
  }

  /** Whether it would, had the user not gone elsewhere. */
  boolean paused() {
    return possible && !now;
  }

  /** Whether that is news. */
  boolean set(boolean on) {
    if (!possible || now == on) {
      return false;
    }
    now = on;
    changed.accept(on);
    return true;
  }
}
