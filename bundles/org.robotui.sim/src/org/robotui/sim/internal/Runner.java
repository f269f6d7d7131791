package org.robotui.sim.internal;

import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.function.LongConsumer;

/** Makes steps at a fixed rate on a thread of its own until it is closed. */
public final class Runner implements AutoCloseable {
  private static final long JOIN_MILLIS = 300;

  private final LongConsumer step;
  private final Consumer<RuntimeException> failed;
  private final Timetable timetable;
  private final Thread thread;
  private volatile boolean closed;

  /**
   * @param step is told when it was due, nanoseconds of {@link System#nanoTime()}
   * @param factor how many times faster than real
   * @param failed hears of what a step threw; there is no further step
   */
  public Runner(LongConsumer step, double factor, Consumer<RuntimeException> failed) {
    this.step = step;
    this.failed = failed;
    timetable = new Timetable(System.nanoTime(), factor);
    thread = Thread.ofPlatform().name("simulation").daemon().unstarted(this::run);
  }

  public void start() {
    thread.start();
  }

  private void run() {
    try {
      makeSteps();
    } catch (RuntimeException e) {
      failed.accept(e);
    }
  }

  private void makeSteps() {
    while (!closed) {
      long due = timetable.nextDue();
      waitUntil(due);
      timetable.stepMade(System.nanoTime());
      if (!closed) {
        step.accept(due);
      }
    }
  }

  private void waitUntil(long due) {
    long wait = due - System.nanoTime();
    while (wait > 0 && !closed) {
      LockSupport.parkNanos(wait);
      wait = due - System.nanoTime();
    }
  }

  /** Waits a short time for the running step to end. */
  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread);
    try {
      thread.join(JOIN_MILLIS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
