package org.robotui.net.thread;

import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadFactory;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Starts threads from an injected factory and knows which of them still run. Safe for all threads. */
public final class Workers {

  private static final Logger LOG = LoggerFactory.getLogger(Workers.class);
  private static final int NANOS_PER_MILLI = 1_000_000;

  private final ThreadFactory factory;
  private final Set<Thread> running = ConcurrentHashMap.newKeySet();

  /**
   * Runs nothing yet.
   *
   * @param factory makes each thread; whether they are daemons is its choice
   */
  public Workers(ThreadFactory factory) {
    this.factory = Objects.requireNonNull(factory, "factory");
  }

  /**
   * Starts a thread. What its work throws ends the thread and is logged with its name.
   *
   * @param name of the thread, as it is seen in dumps and logs
   * @param work ends by itself or when what it reads is closed
   */
  public void start(String name, Runnable work) {
    Thread thread = factory.newThread(() -> run(name, work));
    thread.setName(name);
    running.add(thread);
    try {
      thread.start();
    } catch (Throwable e) {
      running.remove(thread);
      throw e;
    }
  }

  private void run(String name, Runnable work) {
    try {
      work.run();
    } catch (RuntimeException | Error e) {
      LOG.error("{} ended by an error", name, e);
    } finally {
      running.remove(Thread.currentThread());
    }
  }

  /**
   * Blocks until all threads but the caller's have ended, or a deadline has passed. An interrupt does not cut the wait
   * short: who closes something because it was interrupted must leave no thread behind either. The interrupt is there
   * when this returns.
   *
   * @param deadline a time of {@link System#nanoTime}
   * @return whether all have ended
   */
  public boolean join(long deadline) {
    for (Thread thread : running) {
      if (thread != Thread.currentThread()) {
        join(thread, deadline);
      }
    }
    return running.stream().allMatch(thread -> thread == Thread.currentThread());
  }

  private static void join(Thread thread, long deadline) {
    Uninterruptibles.await(deadline, nanos -> {
      if (nanos >= NANOS_PER_MILLI) {
        thread.join(nanos / NANOS_PER_MILLI); // 0 would be for ever
      }
    });
  }
}
