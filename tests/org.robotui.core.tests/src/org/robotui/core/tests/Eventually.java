package org.robotui.core.tests;

import java.time.Duration;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.junit.jupiter.api.Assertions;

/** Waits for what other threads do. */
final class Eventually {
  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final long STEP_NANOS = 5_000_000;

  private Eventually() {}

  /** Waits until it holds; fails after a minute with what there is instead. */
  static void await(String what, BooleanSupplier condition, Supplier<?> instead) {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        Assertions.fail("waited in vain until " + what + "; there is " + instead.get());
      }
      LockSupport.parkNanos(STEP_NANOS);
    }
  }
}
