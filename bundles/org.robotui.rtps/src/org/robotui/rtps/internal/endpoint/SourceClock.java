package org.robotui.rtps.internal.endpoint;

import java.time.Instant;
import java.util.concurrent.TimeUnit;

/** The time of day in nanoseconds since 1970, as source times have it. */
public final class SourceClock {

  private SourceClock() {}

  /** The time now. */
  public static long nanos() {
    Instant now = Instant.now();
    return TimeUnit.SECONDS.toNanos(now.getEpochSecond()) + now.getNano();
  }
}
