package org.robotui.core.internal.support;

import java.util.concurrent.atomic.AtomicLong;
import org.robotui.core.internal.time.NanoClock;

/** A clock that stands still until it is moved. */
public final class ManualClock implements NanoClock {
  private final AtomicLong now = new AtomicLong(1_000_000_000_000L);

  @Override
  public long nanos() {
    return now.get();
  }

  /** Moves it. */
  public void advanceMillis(long millis) {
    now.addAndGet(millis * 1_000_000);
  }
}
