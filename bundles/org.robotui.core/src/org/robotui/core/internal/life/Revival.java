package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.List;
import java.util.Optional;

/**
 * How often, and after which pause, a view is started again that took too long: it may only have been without a
 * processor. One that goes on like that is left alone in the end; one that was well for long begins anew. On the worker
 * of the RUIC.
 */
final class Revival {
  /** Each pause is twice the one before, so that what starves the machine is not made worse by us. */
  static final List<Duration> PAUSES =
      List.of(Duration.ofSeconds(2), Duration.ofSeconds(4), Duration.ofSeconds(8), Duration.ofSeconds(16),
          Duration.ofSeconds(32));

  /** Who was well for so long has another trouble now. */
  static final Duration WELL = Duration.ofMinutes(10);

  private int tries;
  private long lastNanos;

  /**
   * It took too long, or could not be started again as its thread has not ended.
   *
   * @param nowNanos monotonic
   * @return after which pause to try; none where it is not tried any more
   */
  Optional<Duration> next(long nowNanos) {
    if (tries > 0 && nowNanos - lastNanos > WELL.plus(PAUSES.get(tries - 1)).toNanos()) {
      tries = 0;
    }
    lastNanos = nowNanos;
    return tries < PAUSES.size() ? Optional.of(PAUSES.get(tries++)) : Optional.empty();
  }

  /** The user started it. */
  void begin() {
    tries = 0;
  }
}
