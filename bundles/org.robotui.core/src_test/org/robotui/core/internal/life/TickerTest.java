package org.robotui.core.internal.life;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.Uic;
import org.robotui.core.internal.support.Await;

/** How long a tick may take, on a clock of the test. */
class TickerTest {
  private final Semaphore ticks = new Semaphore(0);
  private final AtomicInteger begun = new AtomicInteger();
  private final List<String> failures = new CopyOnWriteArrayList<>();
  private final Ticker ticker = new Ticker(new Slow(), 1000, Thread.ofPlatform().daemon().factory(), () -> { }, failures::add, System::nanoTime);

  /** Ticks as often as it may. */
  private final class Slow implements Uic {
    @Override
    public boolean tick(long nowNanos) {
      begun.incrementAndGet();
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
    check(Duration.ofSeconds(8));
    assertEquals(List.of(), failures);
    ticks.release();
    awaitTick(2);
    check(Duration.ofSeconds(1));
    assertEquals(List.of(), failures);
    check(Duration.ofSeconds(3));
    assertEquals(List.of("did not return from tick within 2 s"), failures);
  }

  @Test
  void aFirstTickThatNeverReturnsIsGivenUpToo() {
    ticker.start();
    ticker.select(true);
    awaitTick(1);
    check(Duration.ofSeconds(11));
    assertEquals(List.of("did not return from tick within 10 s"), failures);
  }
}
