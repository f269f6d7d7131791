package org.robotui.ros.internal.io;

/**
 * Waits that no interrupt cuts short, for ends that take a bounded time and must be whole: who ends a node may do it because it was itself
 * interrupted.
 */
public final class Uninterrupted {

  /** Something that can be waited for. */
  @FunctionalInterface
  public interface Wait {

    /** Waits so many nanoseconds at most; not at all where they are not positive. */
    void atMost(long nanos) throws InterruptedException;
  }

  private Uninterrupted() {
  }

  /** Waits until a time of {@link System#nanoTime} at most. An interrupt is there for the caller when it returns. */
  public static void until(long deadline, Wait wait) {
    boolean interrupted = false;
    for (boolean over = false; !over; ) {
      try {
        wait.atMost(deadline - System.nanoTime());
        over = true;
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
