package org.robotui.net.thread;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

class WorkersTest {

  private static final Duration LONG = Duration.ofSeconds(60);

  private final Workers workers = new Workers(Thread.ofPlatform().daemon().factory());

  private static long in(Duration time) {
    return System.nanoTime() + time.toNanos();
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Test
  void whatThrowsHasEnded() {
    workers.start("one", () -> {
      throw new IllegalStateException("on purpose");
    });
    assertTrue(workers.join(in(LONG)));
  }

  @Test
  void aThreadThatGoesOnIsWaitedForUntilTheDeadline() {
    CountDownLatch end = new CountDownLatch(1);
    workers.start("stays", () -> await(end));
    assertFalse(workers.join(in(Duration.ofMillis(20))));
    end.countDown();
    assertTrue(workers.join(in(LONG)));
  }

  @Test
  void anInterruptDoesNotCutTheWaitShort() {
    Thread waiting = Thread.currentThread();
    workers.start("slow", () -> {
      while (waiting.getState() != Thread.State.TIMED_WAITING) {
        Thread.onSpinWait();
      }
    });
    waiting.interrupt();
    assertTrue(workers.join(in(LONG)));
    assertTrue(Thread.interrupted(), "the caller may want to know");
  }

  @Test
  void aWorkerDoesNotWaitForItself() throws InterruptedException {
    CountDownLatch joined = new CountDownLatch(1);
    workers.start("closes itself", () -> {
      if (workers.join(in(LONG))) {
        joined.countDown();
      }
    });
    joined.await();
  }
}
