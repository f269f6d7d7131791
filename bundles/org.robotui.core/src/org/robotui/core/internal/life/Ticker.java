package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.concurrent.ThreadFactory;
import org.robotui.api.Uic;
import org.robotui.core.internal.fence.Thrown;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.core.internal.watch.Watch.Watched;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Ticks one view on a thread of its own while it is selected. A tick that throws or hangs ends the ticking. */
final class Ticker implements Watched, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Ticker.class);
  private static final double FASTEST_HZ = 1000;
  private static final double SLOWEST_HZ = 0.01;
  private static final long NOT_TICKING = Long.MIN_VALUE;

  /** Is told, once, why the ticking has ended. Must not block. */
  interface End {
    /** A tick threw; a sentence. */
    void threw(String reason);

    /** A tick did not return within its limit. */
    void late(Duration limit);
  }

  private final Uic uic;
  private final long periodNanos;
  private final Runnable frameReady;
  private final End ended;
  private final NanoClock clock;
  private final Thread thread;
  private final TickDoubt doubt;
  private volatile long tickSince = NOT_TICKING;
  private volatile Duration limit = Limits.FIRST;
  private volatile long done;
  private boolean selected;
  private boolean closed;

  /**
   * A ticker at rest.
   *
   * @param uic whom to tick
   * @param rateHz how often at most
   * @param threads makes its thread
   * @param frameReady is told that there is something new to show
   * @param ended is told why it has
   * @param clock monotonic
   */
  Ticker(Uic uic, double rateHz, ThreadFactory threads, Runnable frameReady, End ended, NanoClock clock) {
    this.uic = uic;
    this.periodNanos = (long) (1e9 / Math.clamp(rateHz, SLOWEST_HZ, FASTEST_HZ));
    this.frameReady = frameReady;
    this.ended = ended;
    this.clock = clock;
    this.thread = threads.newThread(this::run);
    this.doubt = new TickDoubt(thread);
  }

  void start() {
    thread.start();
  }

  synchronized void select(boolean now) {
    selected = now;
    notifyAll();
  }

  private void run() {
    try {
      long next = clock.nanos();
      while (awaitTurn(next)) {
        // A tick that took too long makes the next one late; the ones in between are left out.
        next = Math.max(next + periodNanos, clock.nanos());
        tick();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // given up, or closed
    }
  }

  private synchronized boolean awaitTurn(long next) throws InterruptedException {
    long left = next - clock.nanos();
    while (!closed && (!selected || left > 0)) {
      long millis = selected ? left / 1_000_000 : 0;
      wait(millis, selected ? (int) (left % 1_000_000) : 0);
      left = next - clock.nanos();
    }
    return !closed;
  }

  private void tick() {
    long now = clock.nanos();
    tickSince = now;
    try {
      if (uic.tick(now)) {
        frameReady.run();
      }
    } catch (RuntimeException | Error e) { // foreign code may throw anything; it must not end more than this view
      Thrown.log(LOG, "A tick on " + thread.getName() + " failed", e);
      giveUp(() -> ended.threw("threw " + Thrown.text(e) + " in tick"));
    } finally {
      tickSince = NOT_TICKING;
      limit = Limits.TICK;
      done = done + 1; // written by this thread alone
    }
  }

  private void giveUp(Runnable told) {
    if (end()) {
      told.run();
    }
  }

  private synchronized boolean end() {
    boolean first = !closed;
    closed = true;
    notifyAll();
    return first;
  }

  @Override
  public void check(long now) {
    Duration most = limit; // before the time: the limit of a tick that has just ended is never the shorter one
    long since = tickSince;
    if (since != NOT_TICKING && now - since > most.toNanos()
        && doubt.hangs(since, Duration.ofNanos(now - since), most)) {
      giveUp(() -> ended.late(most));
      thread.interrupt();
    }
  }

  @Override
  public void close() {
    end();
  }

  /** How many ticks have ended. */
  long done() {
    return done;
  }

  /** Whether its thread has not ended. */
  boolean isAlive() {
    return thread.isAlive();
  }

  /** Waits for the thread's end; false where it hangs. Interrupts it half-way. */
  boolean awaitEnd(long millis) throws InterruptedException {
    thread.join(Math.max(1, millis / 2));
    if (thread.isAlive()) {
      thread.interrupt();
      thread.join(Math.max(1, millis / 2));
    }
    return !thread.isAlive();
  }
}
