package org.robotui.api.link;

import java.time.Duration;

/**
 * Whether a robot is heard. A network that stalls takes what is sent and delivers it later, all at once; a motion must
 * not wait there. The silence of what usually comes often tells of it much sooner than any connection does. Safe for
 * all threads.
 */
public final class Pulse {
  private static final long SILENCE_NANOS = Duration.ofMillis(500).toNanos();
  /** What comes more rarely may be silent as long without any meaning. */
  private static final double OFTEN_NANOS = Duration.ofMillis(100).toNanos();
  private static final double WEIGHT = 0.05;

  private long heardAt;
  private double period = Double.POSITIVE_INFINITY;

  /** Of a robot that has not been heard yet. */
  public Pulse() {
    // nothing is expected before the first message
  }

  /**
   * A message of the robot has come.
   *
   * @param nowNanos {@link System#nanoTime()}
   */
  public synchronized void heard(long nowNanos) {
    long since = nowNanos - heardAt;
    boolean first = heardAt == 0 || Double.isInfinite(period);
    period = first ? SILENCE_NANOS : period + WEIGHT * (Math.min(since, SILENCE_NANOS) - period);
    heardAt = nowNanos;
  }

  /**
   * The robot has answered a question: if messages do not come all the same, the network is not the reason.
   *
   * @param nowNanos {@link System#nanoTime()}
   */
  public synchronized void answered(long nowNanos) {
    if (silentFor(nowNanos) > 0) {
      period = Double.POSITIVE_INFINITY;
    }
  }

  /**
   * How long the robot has been silent although it usually is not.
   *
   * @param nowNanos {@link System#nanoTime()}
   * @return nanoseconds, 0 where all is well or cannot be told
   */
  public synchronized long silentFor(long nowNanos) {
    long since = nowNanos - heardAt;
    return period < OFTEN_NANOS && since > SILENCE_NANOS ? since : 0;
  }
}
