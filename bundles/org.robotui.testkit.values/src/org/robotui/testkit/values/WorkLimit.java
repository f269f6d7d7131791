package org.robotui.testkit.values;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;

/**
 * A bound on the work of a thread, in time of the processor, so that it is the same on a busy machine. Where it is far
 * exceeded, nothing but the end of the program helps: what the thread does is said then. Begins where it is made, ends
 * with {@link #close}.
 */
final class WorkLimit implements AutoCloseable {
  private static final long MOST = TimeUnit.SECONDS.toNanos(5);
  private static final long HANGS = TimeUnit.SECONDS.toNanos(60);
  private static final Duration LOOK = Duration.ofSeconds(1);
  private static final int EXIT = 70;

  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
  private final Supplier<String> what;
  private final Thread worker = Thread.currentThread();
  private final long begun = threads.getCurrentThreadCpuTime();
  private final CountDownLatch over = new CountDownLatch(1);

  WorkLimit(Supplier<String> what) {
    this.what = what;
    Thread watch = new Thread(this::watch, "work limit");
    watch.setDaemon(true);
    watch.start();
  }

  private long spent() {
    return threads.getThreadCpuTime(worker.threadId()) - begun;
  }

  private void watch() {
    try {
      while (!over.await(LOOK.toMillis(), TimeUnit.MILLISECONDS)) {
        if (spent() > HANGS) {
          System.getLogger(WorkLimit.class.getName()).log(System.Logger.Level.ERROR,
              "hangs: " + what.get() + "\n" + Arrays.toString(worker.getStackTrace()));
          Runtime.getRuntime().halt(EXIT);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void close() {
    over.countDown();
    long spent = spent();
    if (spent > MOST) {
      throw new AssertionError("took " + TimeUnit.NANOSECONDS.toMillis(spent) + " ms of the processor");
    }
  }
}
