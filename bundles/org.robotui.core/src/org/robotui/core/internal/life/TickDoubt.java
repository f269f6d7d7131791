package org.robotui.core.internal.life;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;

/**
 * Tells a tick that hangs from one that a busy machine lets wait: the first waits for something each time one looks, or
 * has had the processor for as long as a tick may take. One that could run and is not let, or reads from a slow disk,
 * has five times its limit. For the thread that looks.
 */
final class TickDoubt {
  private static final int MOST_LIMITS = 5;
  private static final int LOOKS = 3;

  private final Thread thread;
  private long doubted = Long.MIN_VALUE;
  private long busyNanos;
  private int waits;

  TickDoubt(Thread thread) {
    this.thread = thread;
  }

  /**
   * Looks at a tick that is over its limit.
   *
   * @param since when it began, by which it is known
   * @param taken how long it has taken
   * @param limit how long it may take
   * @return whether it hangs
   */
  boolean hangs(long since, Duration taken, Duration limit) {
    if (since != doubted) {
      doubted = since;
      busyNanos = processorNanos();
      waits = 0;
    }
    waits = thread.getState() == Thread.State.RUNNABLE ? 0 : waits + 1;
    return waits >= LOOKS || processorNanos() - busyNanos > limit.toNanos()
        || taken.compareTo(limit.multipliedBy(MOST_LIMITS)) > 0;
  }

  /** Of its whole life; without an answer, which not every virtual machine has, only the longest time counts. */
  private long processorNanos() {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    return threads.isThreadCpuTimeSupported() ? threads.getThreadCpuTime(thread.threadId()) : 0;
  }
}
