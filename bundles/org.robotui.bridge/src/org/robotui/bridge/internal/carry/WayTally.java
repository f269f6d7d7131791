package org.robotui.bridge.internal.carry;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.api.time.RateMeter;

/** Counts what becomes of values. The threads that say values at the other side tell it. */
final class WayTally {
  private static final double SMOOTHING = 0.1;

  private final RateMeter rate = new RateMeter(System.nanoTime());
  private final AtomicLong refused = new AtomicLong();
  private volatile Optional<String> refusal = Optional.empty();
  private volatile double lag = Double.NaN;

  void answered(Optional<String> reason, long receivedNanos) {
    if (reason.isPresent()) {
      refused.incrementAndGet();
    } else {
      long now = System.nanoTime();
      rate.mark(now);
      double seconds = (now - receivedNanos) * 1e-9;
      lag = Double.isNaN(lag) ? seconds : lag + SMOOTHING * (seconds - lag);
    }
    refusal = reason;
  }

  long passed() {
    return rate.count();
  }

  long refused() {
    return refused.get();
  }

  /** Why the last one was refused; none where it was not. */
  Optional<String> refusal() {
    return refusal;
  }

  double rateHz() {
    return rate.rateHz(System.nanoTime());
  }

  double lagSeconds() {
    return lag;
  }
}
