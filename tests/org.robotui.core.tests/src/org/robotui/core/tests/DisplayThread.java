package org.robotui.core.tests;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.robotui.api.host.Host;

/** A thread that does what the display thread of an application does: it beats, and runs what views want run. */
final class DisplayThread implements AutoCloseable {
  private static final long PERIOD_MILLIS = 40;

  private final Host host;
  private final BlockingQueue<Runnable> work = new LinkedBlockingQueue<>();
  private final Thread thread;
  private volatile long lastBeat;
  private volatile boolean closed;

  DisplayThread(Host host) {
    this.host = host;
    this.thread = Thread.ofPlatform().daemon().name("display-of-the-test").start(this::run);
  }

  private void run() {
    while (!closed) {
      lastBeat = System.nanoTime();
      host.displayAlive();
      runOne();
    }
  }

  private void runOne() {
    try {
      Runnable next = work.poll(PERIOD_MILLIS, TimeUnit.MILLISECONDS);
      if (next != null) {
        next.run();
      }
    } catch (InterruptedException e) {
      // The test has ended what held it up.
    }
  }

  void execute(Runnable what) {
    work.add(what);
  }

  /** Ends what holds it up. */
  void interrupt() {
    thread.interrupt();
  }

  /** When it last beat, by the monotonic clock. */
  long lastBeat() {
    return lastBeat;
  }

  @Override
  public void close() throws InterruptedException {
    closed = true;
    thread.interrupt();
    thread.join();
  }
}
