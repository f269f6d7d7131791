package org.robotui.ros.internal.io;

import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadFactory;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Starts threads from an injected factory and knows which of them still run. */
public final class Workers {

  private static final Logger LOG = LoggerFactory.getLogger(Workers.class);

  private final ThreadFactory factory;
  private final Set<Thread> running = ConcurrentHashMap.newKeySet();

  public Workers(ThreadFactory factory) {
    this.factory = Objects.requireNonNull(factory, "factory");
  }

  /** Starts a thread; what it throws is logged with its name. */
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

  /** Waits until all threads but the caller's have ended, or the deadline ({@link System#nanoTime}) has passed. */
  public boolean join(long deadline) {
    for (Thread thread : running) {
      if (thread != Thread.currentThread()) {
        joinOne(thread, deadline);
      }
    }
    return running.stream().allMatch(thread -> thread == Thread.currentThread());
  }

  private static void joinOne(Thread thread, long deadline) {
    Uninterrupted.until(deadline, nanos -> {
      if (nanos >= 1_000_000) {
        thread.join(nanos / 1_000_000); // nothing would be for ever
      }
    });
  }
}
