package org.robotui.rtps.internal.participant;

import java.time.Duration;
import org.robotui.rtps.internal.endpoint.Timers;

/**
 * The time in which this process was there to listen. While it was stopped, nobody's lease ran out: what others sent in
 * that time still waits in the sockets, or was lost for no fault of theirs.
 */
final class Attention {

  /** It is looked at as often as this. */
  static final long PERIOD = Duration.ofMillis(500).toNanos();

  private final Timers timers;
  private volatile long missed;
  private long last;

  Attention(Timers timers) {
    this.timers = timers;
    this.last = timers.now();
  }

  /** The time now, in nanoseconds. */
  long now() {
    return timers.now() - missed;
  }

  /** Called in every period; what was longer than two of them was no attention. */
  void look(long now) {
    long passed = now - last;
    if (passed > 2 * PERIOD) {
      missed += passed - PERIOD;
    }
    last = now;
  }
}
