package org.robotui.ros2.internal.link;

import java.time.Duration;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;

/** Waits for what others do, by looking again and again. */
public final class Waiting {

  private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(5);

  private Waiting() {}

  /**
   * Waits until a condition holds.
   *
   * @param patience at most so long
   * @param over whether it will never hold
   * @param condition what is waited for
   * @return whether it holds
   */
  public static boolean until(Duration patience, BooleanSupplier over, BooleanSupplier condition) {
    long deadline = System.nanoTime() + patience.toNanos();
    while (!condition.getAsBoolean()) {
      if (over.getAsBoolean() || System.nanoTime() - deadline >= 0 || Thread.currentThread().isInterrupted()) {
        return false;
      }
      LockSupport.parkNanos(LOOK_NANOS);
    }
    return true;
  }
}
