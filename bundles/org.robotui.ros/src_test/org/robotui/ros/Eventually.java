package org.robotui.ros;

import java.time.Duration;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Assertions;

/** Waits for conditions of other threads. */
public final class Eventually {

  private Eventually() {}

  /** Waits up to thirty seconds and fails if the condition never held. */
  public static void await(String what, BooleanSupplier condition) {
    await(what, Duration.ofSeconds(30), condition);
  }

  /** Waits so long at most and fails if the condition never held. */
  public static void await(String what, Duration time, BooleanSupplier condition) {
    long deadline = System.nanoTime() + time.toNanos();
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > deadline) {
        Assertions.fail("waited " + time.toMillis() + " ms in vain for: " + what);
      }
      LockSupport.parkNanos(2_000_000);
    }
  }
}
