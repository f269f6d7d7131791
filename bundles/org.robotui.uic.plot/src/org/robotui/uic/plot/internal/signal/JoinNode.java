package org.robotui.uic.plot.internal.signal;

import java.util.ArrayList;
import java.util.List;

/**
 * Brings several signals to the times of the first: the others are taken between their two nearest samples, linearly,
 * so that the result waits until each has reached that time. Where one has a break there, so has the result; what lies
 * before the first sample of another is left out. What waits is bounded.
 */
final class JoinNode {
  static final int MOST_WAITING = 1 << 16;

  private final Met out;
  private final SampleQueue reference = new SampleQueue();
  private final List<Other> others = new ArrayList<>();
  private final double[] values;

  /** Takes what all signals have at a time, in their order; the values are good during the call. */
  @FunctionalInterface
  interface Met {
    void accept(long time, double[] values);
  }

  JoinNode(int inputs, Met out) {
    this.out = out;
    this.values = new double[inputs];
    for (int i = 1; i < inputs; i++) {
      others.add(new Other());
    }
  }

  /** Where the samples of one signal go in. */
  Sink input(int index) {
    SampleQueue queue = index == 0 ? reference : others.get(index - 1).waiting;
    return (time, value) -> {
      queue.add(time, value);
      advance();
      bound(queue);
    };
  }

  private void bound(SampleQueue queue) {
    while (queue.size() > MOST_WAITING) {
      queue.remove();
    }
  }

  private void advance() {
    while (!reference.isEmpty() && step(reference.time(0), reference.value(0))) {
      reference.remove();
    }
  }

  /** False where it must wait. */
  private boolean step(long time, double value) {
    boolean known = true;
    for (Other other : others) {
      if (!other.reach(time)) {
        return false;
      }
      known &= other.began;
    }
    if (known) {
      values[0] = value;
      for (int i = 1; i < values.length; i++) {
        values[i] = others.get(i - 1).at(time);
      }
      out.accept(time, values);
    }
    return true;
  }

  private static final class Other {
    private final SampleQueue waiting = new SampleQueue();
    private boolean began;
    private long lastTime;
    private double last;

    /** Goes on to the last sample at or before a time; false where more must come before the value there is known. */
    boolean reach(long time) {
      while (!waiting.isEmpty() && waiting.time(0) <= time) {
        began = true;
        lastTime = waiting.time(0);
        last = waiting.value(0);
        waiting.remove();
      }
      return !waiting.isEmpty() || began && lastTime == time;
    }

    double at(long time) {
      if (lastTime == time) {
        return last;
      }
      double share = (double) (time - lastTime) / (waiting.time(0) - lastTime);
      return last + (waiting.value(0) - last) * share;
    }
  }
}
