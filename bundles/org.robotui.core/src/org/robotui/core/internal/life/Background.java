package org.robotui.core.internal.life;

import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.robotui.core.internal.fence.Thrown;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Runs tasks of one component that may block, one after the other. Its thread comes with the first task and goes when
 * it is idle.
 */
final class Background implements Executor, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Background.class);
  private static final int WAITING = 1000;
  private static final long IDLE_SECONDS = 5;

  private final String name;
  private final Consumer<String> failed;
  private final ThreadPoolExecutor worker;
  private boolean told; // one task runs at a time

  /**
   * Without a thread.
   *
   * @param name of the component
   * @param threads make its thread
   * @param failed is told, once, that a task has thrown
   */
  Background(String name, ThreadFactory threads, Consumer<String> failed) {
    this.name = name;
    this.failed = failed;
    this.worker =
        new ThreadPoolExecutor(1, 1, IDLE_SECONDS, TimeUnit.SECONDS, new LinkedBlockingQueue<>(WAITING), threads);
    worker.allowCoreThreadTimeOut(true);
  }

  /** Views call this from the display thread too: what cannot be taken is said in the log, not thrown at them. */
  @Override
  public void execute(Runnable task) {
    try {
      worker.execute(() -> run(task));
    } catch (RejectedExecutionException e) {
      forget();
    }
  }

  private void forget() {
    if (!worker.isShutdown()) {
      LOG.warn("{}: a task is forgotten, as {} wait already", name, WAITING);
    }
  }

  private void run(Runnable task) {
    try {
      task.run();
    } catch (RuntimeException | Error e) { // foreign code may throw anything
      Thrown.log(LOG, "A task of " + name + " failed", e);
      tell("threw " + Thrown.text(e) + " in a task");
    }
  }

  private void tell(String what) {
    if (!told) {
      told = true;
      failed.accept(what);
    }
  }

  /** Interrupts the task under way and forgets the others. */
  @Override
  public void close() {
    worker.shutdownNow();
  }
}
