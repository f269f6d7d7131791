package org.robotui.lcm.tests;

import java.time.Duration;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.junit.jupiter.api.Assertions;

/** Waits for conditions of other threads and processes. */
final class Eventually {

  private static final Duration TIME = Duration.ofSeconds(60);

  private Eventually() {}

  static void await(String what, BooleanSupplier condition) {
    await(() -> what, condition);
  }

  static void await(Supplier<String> what, BooleanSupplier condition) {
    long deadline = System.nanoTime() + TIME.toNanos();
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > deadline) {
        Assertions.fail("waited " + TIME.toSeconds() + " s in vain for: " + what.get());
      }
      LockSupport.parkNanos(10_000_000);
    }
  }
}
