package org.robotui.net.thread;

/**
 * Waits that no interrupt cuts short, for ends that take a bounded time and must be whole: who closes something may do
 * it because it was itself interrupted.
 */
public final class Uninterruptibles {

  /** Something that can be waited for. */
  @FunctionalInterface
  public interface Wait {

    /**
     * Waits.
     *
     * @param nanos at most so many nanoseconds; not at all where they are not positive
     * @throws InterruptedException if interrupted; it is then called again with what is left
     */
    void atMost(long nanos) throws InterruptedException;
  }

  private Uninterruptibles() {}

  /**
   * Waits until a deadline at most. An interrupt is there for the caller when it returns.
   *
   * @param deadline a time of {@link System#nanoTime}
   * @param wait waits on this thread
   */
  public static void await(long deadline, Wait wait) {
    boolean interrupted = false;
    for (boolean over = false; !over;) {
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
