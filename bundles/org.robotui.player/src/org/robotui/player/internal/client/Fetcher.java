package org.robotui.player.internal.client;

import java.time.Duration;

/** When to fetch data in pull mode: at most once in a period, and not before the last round has ended. */
final class Fetcher {

  /** The request for data. */
  static final int FETCH = 4;
  /** The mark at a round's end. */
  private static final int END = 1;

  private final long period;
  private final long patience;
  private long last;
  private boolean outstanding;
  private boolean first = true;

  Fetcher(Duration period, Duration patience) {
    this.period = period.toNanos();
    this.patience = patience.toNanos();
  }

  /** Whether to fetch now; then the round begins. */
  synchronized boolean isDue(long now) {
    boolean due = first || now - last >= (outstanding ? patience : period);
    if (due) {
      first = false;
      outstanding = true;
      last = now;
    }
    return due;
  }

  /** When to look again, by {@link System#nanoTime}. */
  synchronized long nextLook(long now) {
    return Math.max(now, last + (outstanding ? patience : period));
  }

  synchronized void synced(int subtype) {
    outstanding &= subtype != END;
  }
}
