package org.robotui.core.internal.watch;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;
import org.robotui.core.internal.fence.Thrown;
import org.robotui.core.internal.time.NanoClock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The thread that looks for what hangs, ten times a second. It only looks: what it calls must not block. Where it could
 * not look itself for a while, as the process was stopped or the machine slept, nobody else could do anything either:
 * all have some time before it looks again.
 */
public final class Watch implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Watch.class);
  private static final long PERIOD_NANOS = 100_000_000L;
  /** No busy machine keeps it from looking for so long. */
  private static final long STOPPED_NANOS = 1_000_000_000L;
  /** As long as a tick may take. */
  private static final long GRACE_NANOS = 2_000_000_000L;

  /** Something that may hang. */
  @FunctionalInterface
  public interface Watched {
    /** Looks; {@code now} is monotonic. */
    void check(long now);
  }

  private final NanoClock clock;
  private final List<Watched> watched = new CopyOnWriteArrayList<>();
  private final Thread thread;
  private volatile boolean closed;
  /** On the thread only, as the next. */
  private long looked;
  private long patientUntil;

  /** Starts to look. */
  public Watch(NanoClock clock) {
    this.clock = clock;
    looked = clock.nanos();
    patientUntil = looked;
    thread = Thread.ofPlatform().daemon().name("robotui-watch").start(this::run);
  }

  /** Looks after something from now on. */
  public void add(Watched what) {
    watched.add(what);
  }

  /** Looks after it no more. */
  public void remove(Watched what) {
    watched.remove(what);
  }

  private void run() {
    while (!closed) {
      look();
      LockSupport.parkNanos(this, PERIOD_NANOS);
    }
  }

  private void look() {
    try {
      long now = clock.nanos();
      patientUntil = now - looked > STOPPED_NANOS ? now + GRACE_NANOS : patientUntil;
      looked = now;
      if (now - patientUntil >= 0) {
        watched.forEach(w -> check(w, now));
      }
    } catch (RuntimeException | Error e) { // going through the list needs memory as well: what is left is looked at
                                           // next time
      Thrown.log(LOG, "Looking failed", e);
    }
  }

  private static void check(Watched what, long now) {
    try {
      what.check(now);
    } catch (RuntimeException | Error e) { // who looks for what hangs must outlive what there is
      Thrown.log(LOG, "Looking after something failed", e);
    }
  }

  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread);
  }
}
