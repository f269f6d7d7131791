package org.robotui.core.internal.time;

import java.time.Instant;

/** The clock of this machine, replaceable in tests. */
@FunctionalInterface
public interface WallClock {
  /** The system's clock. */
  WallClock SYSTEM = () -> {
    Instant now = Instant.now();
    return now.getEpochSecond() * 1_000_000_000L + now.getNano();
  };

  /** Nanoseconds since 1970. */
  long nanos();
}
