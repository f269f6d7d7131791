package org.robotui.core.internal.life;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import org.robotui.core.internal.fence.Thrown;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Runs the tasks of one RUIC one after the other. After closing, tasks are dropped. */
final class SerialWorker implements Executor, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(SerialWorker.class);
  private static final Runnable END = () -> {};

  private final BlockingQueue<Runnable> tasks = new LinkedBlockingQueue<>();
  private final Thread thread;
  private volatile boolean closed;

  SerialWorker(String name) {
    thread = Thread.ofPlatform().daemon().name(name).start(this::run);
  }

  @Override
  public void execute(Runnable task) {
    if (!closed) {
      tasks.add(task);
    }
  }

  private void run() {
    try {
      Runnable task = tasks.take();
      while (task != END) {
        runOne(task);
        task = tasks.take();
      }
    } catch (InterruptedException e) {
      LOG.debug("{} was interrupted and ends", thread.getName());
    }
  }

  private void runOne(Runnable task) {
    try {
      task.run();
    } catch (RuntimeException | Error e) { // whatever it was, the RUIC must still be able to end
      Thrown.log(LOG, "A task of " + thread.getName() + " failed", e);
    }
  }

  /** Ends after the tasks that are there already. */
  @Override
  public void close() {
    closed = true;
    tasks.add(END);
  }

  boolean isAlive() {
    return thread.isAlive();
  }
}
