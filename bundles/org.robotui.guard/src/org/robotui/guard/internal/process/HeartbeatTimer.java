package org.robotui.guard.internal.process;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * How long no beat was heard. Time in which this process itself did not run is not counted. Beats come from any thread,
 * all else from one.
 */
final class HeartbeatTimer {
  private static final long MOST_AT_ONCE = Duration.ofMillis(100).toNanos();

  private final AtomicBoolean heard = new AtomicBoolean();
  private long quiet;
  private long last;

  HeartbeatTimer(long now) {
    this.last = now;
  }

  void beat() {
    heard.set(true);
  }

  /** Asked again and again: for how many nanoseconds it has been silent. */
  long at(long now) {
    quiet = heard.getAndSet(false) ? 0 : quiet + Math.min(now - last, MOST_AT_ONCE);
    last = now;
    return quiet;
  }

  /** What {@link #at} answered last. */
  long quiet() {
    return quiet;
  }
}
