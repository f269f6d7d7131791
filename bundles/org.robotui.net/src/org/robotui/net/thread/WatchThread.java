package org.robotui.net.thread;

import java.time.Duration;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;

/**
 * Looks at something from time to time, on a thread that lives only while there is something to look at. Any thread may
 * use it.
 */
public final class WatchThread {
  private final ThreadFactory threads;
  private final String name;
  private final long stepNanos;
  private final Runnable look;
  private boolean needed;
  private boolean running;

  /**
   * Has no thread yet.
   *
   * @param threads makes the thread
   * @param name of the thread
   * @param step the time between two looks
   * @param look is called on the thread; not while this object is locked
   */
  public WatchThread(ThreadFactory threads, String name, Duration step, Runnable look) {
    this.threads = threads;
    this.name = name;
    this.stepNanos = step.toNanos();
    this.look = look;
  }

  /** There is something to look at from now on. The first look comes after one step. */
  public synchronized void start() {
    needed = true;
    if (!running) {
      running = true;
      Thread thread = threads.newThread(this::run);
      thread.setName(name);
      thread.start();
    }
  }

  /** There is nothing more to look at; a look may still be under way. Does not wait. */
  public synchronized void stop() {
    needed = false;
    notifyAll();
  }

  private void run() {
    while (pause()) {
      look.run();
    }
  }

  /** Waits a little; answers whether there is still something to look at. */
  private synchronized boolean pause() {
    long until = System.nanoTime() + stepNanos;
    try {
      for (long left = stepNanos; needed && left > 0; left = until - System.nanoTime()) {
        TimeUnit.NANOSECONDS.timedWait(this, left);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      running = false;
      return false;
    }
    running = needed;
    return running;
  }
}
