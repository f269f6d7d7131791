package org.robotui.core.internal.life;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.Uic;
import org.robotui.core.internal.support.Await;

/** How long a tick may take, on a clock of the test. */
class TickerTest {
  private final Semaphore ticks = new Semaphore(0);
  private final AtomicInteger begun = new AtomicInteger();
  private final List<String> failures = new CopyOnWriteArrayList<>();
  private final AtomicBoolean spins = new AtomicBoolean();
  private Thread thread;
  private final Ticker ticker = new Ticker(new Slow(), 1000, this::made, () -> {}, new Ticker.End() {
    @Override
    public void threw(String reason) {
      failures.add(reason);
    }

    @Override
    public void late(Duration limit) {
      failures.add("late by " + limit.toSeconds() + " s");
    }
  }, System::nanoTime);

  /** Ticks as often as it may. */
  private final class Slow implements Uic {
    @Override
    public boolean tick(long nowNanos) {
      begun.incrementAndGet();
      while (spins.get()) {
        Thread.onSpinWait();
      }
      try {
        ticks.acquire();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      return false;
    }

    @Override
    public void close() {
      // Nothing is held.
    }
  }

  private Thread made(Runnable work) {
    thread = Thread.ofPlatform().daemon().unstarted(work);
    return thread;
  }

  /** As often as it takes to be sure that it waits, and is not only caught at it. */
  private void checkAll(Duration later) {
    Await.until("it waits", () -> thread.getState() == Thread.State.WAITING);
    IntStream.range(0, 3).forEach(i -> check(later));
  }

  private void awaitTick(int number) {
    Await.until("tick " + number, () -> begun.get() == number);
  }

  private void check(Duration later) {
    ticker.check(System.nanoTime() + later.toNanos());
  }

  @AfterEach
  void end() throws InterruptedException {
    ticker.close();
    assertTrue(ticker.awaitEnd(5_000));
  }

  @Test
  void theFirstTickMayTakeLongerThanTheOthers() {
    ticker.start();
    ticker.select(true);
    awaitTick(1);
    checkAll(Duration.ofSeconds(8));
    assertEquals(List.of(), failures);
    ticks.release();
    awaitTick(2);
    checkAll(Duration.ofSeconds(1));
    assertEquals(List.of(), failures);
    checkAll(Duration.ofSeconds(3));
    assertEquals(List.of("late by 2 s"), failures);
  }

  @Test
  void aFirstTickThatNeverReturnsIsGivenUpToo() {
    ticker.start();
    ticker.select(true);
    awaitTick(1);
    checkAll(Duration.ofSeconds(11));
    assertEquals(List.of("late by 10 s"), failures);
  }

  @Test
  void oneThatOnlyHadNoProcessorIsGivenTime() {
    spins.set(true);
    ticker.start();
    ticker.select(true);
    awaitTick(1);
    check(Duration.ofSeconds(12));
    check(Duration.ofSeconds(49));
    assertEquals(List.of(), failures);
    check(Duration.ofSeconds(51));
    assertEquals(List.of("late by 10 s"), failures);
    spins.set(false);
  }

  @Test
  void oneThatHasHadTheProcessorForItsLimitIsGivenUp() {
    ticks.release();
    ticker.start();
    ticker.select(true);
    awaitTick(2);
    spins.set(true);
    ticks.release();
    awaitTick(3);
    Await.until("it was given up", () -> {
      check(Duration.ofSeconds(3));
      return !failures.isEmpty();
    });
    assertEquals(List.of("late by 2 s"), failures);
    spins.set(false);
  }
}
