package org.robotui.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class ArrivalsTest {

  @Test
  void whatWasNotTakenGivesWayToTheNewest() throws InterruptedException {
    CountDownLatch busy = new CountDownLatch(1);
    CountDownLatch goOn = new CountDownLatch(1);
    BlockingQueue<Optional<Integer>> taken = new LinkedBlockingQueue<>();
    try (Arrivals arrivals = new Arrivals(Thread.ofPlatform().daemon().factory())) {
      Arrivals.Source<Integer> first = arrivals.source(1, value -> {
        busy.countDown();
        await(goOn);
      });
      Arrivals.Source<Integer> newest = arrivals.source(1, value -> taken.add(Optional.ofNullable(value)));
      first.arrived(0);
      assertTrue(busy.await(10, TimeUnit.SECONDS));
      List.of(1, 2, 3).forEach(newest::arrived);
      goOn.countDown();
      assertEquals(Optional.of(3), taken.poll(10, TimeUnit.SECONDS));
      assertEquals(2, newest.dropped());
      assertNull(taken.poll(200, TimeUnit.MILLISECONDS), "it is taken once");
    }
  }

  @Test
  void aSourceKeepsNoMoreBytesThanFitButOneThatIsLonger() throws InterruptedException {
    CountDownLatch busy = new CountDownLatch(1);
    CountDownLatch goOn = new CountDownLatch(1);
    BlockingQueue<Long> taken = new LinkedBlockingQueue<>();
    try (Arrivals arrivals = new Arrivals(Thread.ofPlatform().daemon().factory())) {
      arrivals.source(1, value -> {
        busy.countDown();
        await(goOn);
      }).arrived(0);
      assertTrue(busy.await(10, TimeUnit.SECONDS));
      Arrivals.Source<Long> some = arrivals.source(100, 10, Long::longValue, taken::add);
      List.of(50L, 4L, 5L, 3L).forEach(some::arrived);
      goOn.countDown();
      assertEquals(5, taken.poll(10, TimeUnit.SECONDS));
      assertEquals(3, taken.poll(10, TimeUnit.SECONDS));
      assertEquals(2, some.dropped());
      some.arrived(60L);
      assertEquals(60, taken.poll(10, TimeUnit.SECONDS));
    }
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await(10, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Test
  void aMessageThatIsTooLongIsPassedOverAndTheNextIsTaken() {
    Assembly assembly = new Assembly(10);
    assertTrue(assembly.binary(ByteBuffer.allocate(8), false).isEmpty());
    assertTrue(assembly.binary(ByteBuffer.allocate(8), true).isEmpty());
    assertTrue(assembly.ended());
    assertEquals(7, assembly.binary(ByteBuffer.allocate(7), true).orElseThrow().remaining());
    assertFalse(assembly.ended());
    assertEquals("ab", assembly.text("ab", true).orElseThrow());
  }
}
