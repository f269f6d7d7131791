package org.robotui.roboframe;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.concurrent.ThreadFactory;
import java.util.function.BooleanSupplier;

/** What these tests share. */
final class BrokerWaiting {
  static final ThreadFactory THREADS = task -> Thread.ofPlatform().daemon().unstarted(task);
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private BrokerWaiting() {}

  static void until(String what, BooleanSupplier condition) throws InterruptedException {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, () -> "waited in vain: " + what);
      Thread.sleep(5);
    }
  }
}
