package org.robotui.uic.map.internal.view;

import java.util.Optional;

/** A brief message: it goes by itself. Display thread. */
final class Toast {
  static final int MILLIS = 4000;

  private Optional<Told> told = Optional.empty();
  private long untilNanos;

  void say(Told message, long nowNanos) {
    told = Optional.of(message);
    untilNanos = nowNanos + MILLIS * 1_000_000L;
  }

  void clear() {
    told = Optional.empty();
  }

  Optional<Told> at(long nowNanos) {
    return told.filter(t -> nowNanos - untilNanos < 0);
  }
}
