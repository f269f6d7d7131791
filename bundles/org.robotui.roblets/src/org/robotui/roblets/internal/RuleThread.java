package org.robotui.roblets.internal;

import java.time.Duration;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.thread.Workers;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Runs rules one after another beside the socket, so that one that takes long loses no datagrams. */
public final class RuleThread implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(RuleThread.class);
  private static final int MOST = 1024;
  private static final int LOOK_MILLIS = 100;
  private static final Duration ENDING = Duration.ofSeconds(1);

  private final BlockingQueue<Due> due = new ArrayBlockingQueue<>(MOST);
  private final LogThrottle left = new LogThrottle();
  private final LogThrottle failed = new LogThrottle();
  private final Workers workers;
  private volatile boolean closed;

  private record Due(String rule, Runnable work) {}

  public RuleThread(String name, ThreadFactory threads) {
    workers = new Workers(threads);
    workers.start(name, this::think);
  }

  /** Later; where rules are too slow, the oldest goes. */
  public void run(String rule, Runnable work) {
    Due next = new Due(rule, work);
    while (!closed && !due.offer(next)) {
      if (due.poll() != null && left.admit()) {
        LOG.warn("rules are slower than what comes: {} left out so far, the latest before '{}'", left.count(), rule);
      }
    }
  }

  private void think() {
    while (!closed) {
      try {
        Due next = due.poll(LOOK_MILLIS, TimeUnit.MILLISECONDS);
        if (next != null) {
          act(next);
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return;
      }
    }
  }

  private void act(Due next) {
    try {
      next.work().run();
    } catch (RuntimeException | LinkageError | StackOverflowError e) {
      if (failed.admit()) {
        LOG.error("the rule '{}' failed ({} failures so far)", next.rule(), failed.count(), e);
      }
    }
  }

  @Override
  public void close() {
    closed = true;
    workers.join(System.nanoTime() + ENDING.toNanos());
  }
}
