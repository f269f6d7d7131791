package org.robotui.workbench.internal.timeline;

import java.util.concurrent.Executor;
import java.util.function.LongConsumer;

/**
 * Passes on where the pointer is while it is dragged: as often as the display comes to it, and only the newest place.
 * Display thread only.
 */
final class NewestSeek {
  private final Executor display;
  private final LongConsumer seek;
  private long wanted;
  private boolean waiting;

  /**
   * Sends nothing yet.
   *
   * @param display runs a task on the display thread when that has taken the input that is there
   * @param seek goes to a time
   */
  NewestSeek(Executor display, LongConsumer seek) {
    this.display = display;
    this.seek = seek;
  }

  void to(long time) {
    wanted = time;
    if (!waiting) {
      waiting = true;
      display.execute(this::send);
    }
  }

  private void send() {
    waiting = false;
    seek.accept(wanted);
  }
}
