package org.robotui.rfic.player.internal.device;

import java.util.Arrays;

/**
 * Whether the data of a device came regularly and have stopped. What never came regularly, as it is sent on change, is
 * never found silent. Data are told on the receiving thread, all else comes from the thread that follows the devices.
 */
final class Rhythm {
  private static final int ENOUGH = 20;
  /** The longest gap of those that count, in usual ones: more is no rhythm. */
  private static final long STEADY = 4;
  private static final long JITTER_NANOS = 100_000_000L;
  private static final long OFTEN_NANOS = 1_000_000_000L;
  private static final long FIRST_PAUSE_NANOS = 5_000_000_000L;
  private static final long LONGEST_PAUSE_NANOS = 60_000_000_000L;

  private final long[] gaps = new long[ENOUGH];
  private long count;
  private long last;
  private boolean heard;
  private long pause = FIRST_PAUSE_NANOS;

  synchronized void heard(long now) {
    long gap = now - last;
    if (heard && gap < FIRST_PAUSE_NANOS) {
      gaps[(int) (count % ENOUGH)] = gap;
      count++;
    }
    heard = true;
    last = now;
    pause = FIRST_PAUSE_NANOS;
  }

  /** The link is lost: what comes then begins anew. */
  synchronized void forget() {
    heard = false;
    count = 0;
    pause = FIRST_PAUSE_NANOS;
  }

  /** Whether data came regularly, be it until now or until they stopped. */
  synchronized boolean isKnown() {
    if (count < ENOUGH) {
      return false;
    }
    long[] sorted = gaps.clone();
    Arrays.sort(sorted);
    long usual = sorted[ENOUGH / 2];
    long longest = sorted[ENOUGH - 1];
    return usual < OFTEN_NANOS && longest < STEADY * usual + JITTER_NANOS;
  }

  /** Whether they came regularly and have not come for longer than can be explained. */
  synchronized boolean isSilent(long now) {
    return now - last > pause && isKnown();
  }

  /** Something was done about the silence: it is waited for longer each time. */
  synchronized void retried(long now) {
    last = now;
    pause = Math.min(2 * pause, LONGEST_PAUSE_NANOS);
  }
}
