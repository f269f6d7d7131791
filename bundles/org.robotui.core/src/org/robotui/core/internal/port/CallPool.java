package org.robotui.core.internal.port;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.Future;
import java.util.concurrent.FutureTask;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * The workers that handle the calls to one robot interface: few, with a bounded queue, so that a hanging robot costs
 * little.
 */
public final class CallPool implements AutoCloseable {
  private static final int WORKERS = 4;
  private static final int WAITING = 32;
  private static final long IDLE_SECONDS = 5;

  private final ThreadFactory threads;
  private final ThreadPoolExecutor workers;

  /** A pool without threads until the first call. */
  public CallPool(ThreadFactory threads) {
    this.threads = threads;
    workers = new ThreadPoolExecutor(
        WORKERS, WORKERS, IDLE_SECONDS, TimeUnit.SECONDS, new ArrayBlockingQueue<>(WAITING), threads);
    workers.allowCoreThreadTimeOut(true);
  }

  /**
   * Runs a call.
   *
   * @throws RejectedExecutionException where too many are under way or the robot interface has ended
   */
  Future<?> submit(Runnable call) {
    return workers.submit(call);
  }

  /** Runs a call at once, whatever else is under way. */
  Future<?> urgent(Runnable call) {
    FutureTask<Boolean> task = new FutureTask<>(call, true);
    threads.newThread(task).start();
    return task;
  }

  /** Interrupts all calls. */
  @Override
  public void close() {
    workers.shutdownNow();
  }
}
