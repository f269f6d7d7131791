package org.robotui.net.thread;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class WatchThreadTest {
  private static final Duration LONG = Duration.ofMinutes(1);
  private static final Duration SHORT = Duration.ofMillis(1);

  private final List<Thread> made = new CopyOnWriteArrayList<>();

  private Thread make(Runnable run) {
    Thread thread = Thread.ofPlatform().daemon().unstarted(run);
    made.add(thread);
    return thread;
  }

  @Test
  void looksAgainAndAgainOnOneThread() throws InterruptedException {
    CountDownLatch looks = new CountDownLatch(3);
    WatchThread watch = new WatchThread(this::make, "watch", SHORT, looks::countDown);
    watch.start();
    watch.start();
    assertTrue(looks.await(10, TimeUnit.SECONDS));
    watch.stop();
    assertEquals(1, made.size());
    assertEquals("watch", made.getFirst().getName());
    made.getFirst().join(10_000);
    assertFalse(made.getFirst().isAlive());
  }

  @Test
  void endsAtOnceWhereThereIsNothingMoreToLookAtAndBeginsAnew() throws InterruptedException {
    WatchThread watch = new WatchThread(this::make, "watch", LONG, () -> {});
    for (int times = 1; times <= 2; times++) {
      watch.start();
      assertEquals(times, made.size());
      watch.stop();
      made.getLast().join(10_000);
      assertFalse(made.getLast().isAlive());
    }
  }

  @Test
  void anInterruptEndsTheThreadAndAnotherOneCanBegin() throws InterruptedException {
    WatchThread watch = new WatchThread(this::make, "watch", LONG, () -> {});
    watch.start();
    made.getFirst().interrupt();
    made.getFirst().join(10_000);
    assertFalse(made.getFirst().isAlive());
    watch.start();
    assertEquals(2, made.size());
    watch.stop();
  }
}
