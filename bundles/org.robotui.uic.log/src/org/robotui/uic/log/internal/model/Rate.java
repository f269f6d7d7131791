package org.robotui.uic.log.internal.model;

import java.util.ArrayDeque;
import java.util.Deque;

/** Entries a second over the last two seconds. One thread. */
final class Rate {
  private static final long SPAN_NANOS = 2_000_000_000L;
  private static final double SPAN_SECONDS = SPAN_NANOS * 1e-9;

  private record Step(long at, int count) {}

  private final Deque<Step> steps = new ArrayDeque<>();
  private long sum;

  void mark(long now, int count) {
    if (count > 0) {
      steps.add(new Step(now, count));
      sum += count;
    }
    while (!steps.isEmpty() && now - steps.getFirst().at > SPAN_NANOS) {
      sum -= steps.removeFirst().count;
    }
  }

  double hertz() {
    return sum / SPAN_SECONDS;
  }
}
