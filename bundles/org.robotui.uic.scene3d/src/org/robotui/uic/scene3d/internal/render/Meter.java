package org.robotui.uic.scene3d.internal.render;

import java.util.ArrayDeque;
import java.util.Deque;

/** Pictures a second, over the last second in which some were made. */
final class Meter {
  private static final long WINDOW_NANOS = 1_000_000_000L;

  private final Deque<Long> times = new ArrayDeque<>();

  void count(long nowNanos) {
    times.add(nowNanos);
    forget(nowNanos);
  }

  double rate(long nowNanos) {
    forget(nowNanos);
    if (times.size() < 2) {
      return times.size();
    }
    double span = (times.getLast() - times.getFirst()) * 1e-9;
    boolean running = nowNanos - times.getLast() < WINDOW_NANOS / 4;
    return running && span > 0 ? (times.size() - 1) / span : times.size();
  }

  private void forget(long nowNanos) {
    while (!times.isEmpty() && nowNanos - times.getFirst() > WINDOW_NANOS) {
      times.poll();
    }
  }
}
