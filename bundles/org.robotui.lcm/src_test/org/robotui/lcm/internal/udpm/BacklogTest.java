package org.robotui.lcm.internal.udpm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/** Datagrams on their way from one thread to another. */
class BacklogTest {

  private static final InetSocketAddress FROM = new InetSocketAddress("127.0.0.1", 7667);

  private static void put(Backlog backlog, int number, int size) throws Exception {
    ByteBuffer room = backlog.room();
    assertEquals(0, room.position());
    for (int at = 0; at < size; at++) {
      room.put((byte) (number + at));
    }
    backlog.add(FROM, room, number);
  }

  private static void assertNext(Backlog backlog, int number, int size) throws Exception {
    Backlog.Entry entry = backlog.take();
    assertEquals(number, entry.received());
    assertEquals(size, entry.bytes().remaining());
    for (int at = 0; at < size; at++) {
      assertEquals((byte) (number + at), entry.bytes().get(at), "byte " + at + " of datagram " + number);
    }
    backlog.done(entry);
  }

  private static int size(int seed, int number) {
    int large = new Random(seed * 31L + number).nextInt(Wire.MOST_DATAGRAM + 1);
    return number % 3 == 0 ? large : large % 200;
  }

  @Test
  void whatWaitsStaysAsItIsWhileSegmentsAreUsedAgain() throws Exception {
    for (int seed = 0; seed < 4; seed++) {
      Backlog backlog = new Backlog(4L << 20);
      Random random = new Random(seed);
      int put = 0;
      int taken = 0;
      while (taken < 1500) {
        if (put < 1500 && put - taken < 40 && (put == taken || random.nextBoolean())) {
          put(backlog, put, size(seed, put++));
        } else {
          assertNext(backlog, taken, size(seed, taken++));
        }
      }
    }
  }

  /** The receiving thread has its room already when all that waited before it is taken. */
  @Test
  void roomThatWasGivenIsNotGivenAgain() throws Exception {
    Backlog backlog = new Backlog(1);
    put(backlog, 1, 100);
    ByteBuffer room = backlog.room();
    assertNext(backlog, 1, 100);
    room.put(new byte[50]);
    backlog.add(FROM, room, 2);
    put(backlog, 3, 200);
    Backlog.Entry second = backlog.take();
    assertEquals(0, second.bytes().get(49));
    backlog.done(second);
    assertNext(backlog, 3, 200);
  }

  @Test
  void twoThreadsPassAllOfThem() throws Exception {
    Backlog backlog = new Backlog(1);
    int count = 3000;
    CompletableFuture<Void> receiver = CompletableFuture.runAsync(() -> {
      try {
        for (int i = 0; i < count; i++) {
          put(backlog, i, size(7, i));
        }
      } catch (Exception e) {
        throw new AssertionError(e);
      }
    });
    for (int i = 0; i < count; i++) {
      assertNext(backlog, i, size(7, i));
    }
    receiver.get(20, TimeUnit.SECONDS);
  }

  @Test
  void itIsBoundedAndItsEndWakesTheReceiver() throws Exception {
    Backlog backlog = new Backlog(1);
    CompletableFuture<Integer> receiver = CompletableFuture.supplyAsync(() -> {
      for (int i = 0;; i++) {
        try {
          put(backlog, i, 60_000);
        } catch (Exception e) {
          return i;
        }
      }
    });
    while (!receiver.isDone()) {
      Thread.sleep(200);
      backlog.discard();
    }
    assertTrue(receiver.get() >= 30 && receiver.get() <= 36, "held " + receiver.get());
    IOException end = assertThrows(IOException.class, backlog::take);
    assertEquals("closed", end.getMessage());
  }

  /** The receiver may be slow to wake: meanwhile also what it was filling is done. */
  @Test
  void segmentsThatAreDoneTogetherAreUsedAgain() throws Exception {
    Backlog backlog = new Backlog(1);
    int both = 34;
    Thread receiver = Thread.ofPlatform().daemon().start(() -> {
      try {
        for (int i = 0; i < 5 * both; i++) {
          put(backlog, i, 60_000);
        }
      } catch (Exception e) {
        throw new AssertionError(e);
      }
    });
    assertTimeoutPreemptively(Duration.ofSeconds(20), () -> {
      for (int round = 0; round < 4; round++) {
        finishAtOnce(backlog, both, receiver);
      }
    });
    backlog.discard();
    receiver.join();
  }

  private static void finishAtOnce(Backlog backlog, int count, Thread receiver) throws Exception {
    List<Backlog.Entry> taken = new ArrayList<>();
    while (taken.size() < count) {
      taken.add(backlog.take());
    }
    while (receiver.getState() != Thread.State.WAITING) {
      Thread.onSpinWait();
    }
    synchronized (backlog) {
      taken.forEach(backlog::done);
    }
  }
}
