package org.robotui.rtps.internal.endpoint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.robotui.rtps.Durability;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.Guid;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Sample;

/** Readers and writers of ours with each other, on links that lose. */
class ReliableLinkTest {

  private static final Guid W = LossyLink.guid(1, 1, EndpointKind.WRITER);
  private static final Guid R = LossyLink.guid(2, 1, EndpointKind.READER);
  private static final Guid R2 = LossyLink.guid(2, 2, EndpointKind.READER);
  private static final Qos RELIABLE = Qos.reliable(100);
  private static final Qos LATCHED = RELIABLE.with(Durability.TRANSIENT_LOCAL);

  private static ByteBuffer bytes(long seed, int size) {
    byte[] bytes = new byte[size];
    new Random(seed).nextBytes(bytes);
    return ByteBuffer.wrap(bytes);
  }

  private static OptionalLong write(WriterCore writer, ByteBuffer payload) {
    return writer.write(Sample.Kind.ALIVE, payload, 1, Optional.empty(), Optional.empty());
  }

  private static void assertAll(List<Change> changes, long from, long to) {
    assertEquals(LongStream.rangeClosed(from, to).boxed().toList(), changes.stream().map(Change::sequence).toList());
  }

  @Test
  void nothingIsLostWhereTheLinkLosesAFifth() {
    for (int seed = 0; seed < 20; seed++) {
      LossyLink link = new LossyLink(seed, 0.2, 3);
      WriterCore writer = link.writer(W, RELIABLE);
      link.reader(R, RELIABLE);
      link.match(W, RELIABLE, R, RELIABLE);
      link.pass(200);
      for (int i = 1; i <= 500; i++) {
        write(writer, bytes(i, 40));
        link.pass(5);
      }
      link.pass(3000);
      assertAll(link.delivered(R), 1, 500);
      assertEquals(bytes(77, 40), link.delivered(R).get(76).payload());
      assertEquals(0, writer.statistics().held(), "what all have acknowledged is kept by no volatile writer");
    }
  }

  @Test
  void imagesComeWholeWhereTheLinkLosesATwentieth() {
    for (int seed = 0; seed < 5; seed++) {
      LossyLink link = new LossyLink(seed, 0.05, 1);
      WriterCore writer = link.writer(W, RELIABLE);
      ReaderCore reader = link.reader(R, RELIABLE);
      link.match(W, RELIABLE, R, RELIABLE);
      link.pass(50);
      for (int i = 1; i <= 20; i++) {
        write(writer, bytes(i, 1 << 20));
        link.pass(100);
      }
      link.pass(2000);
      assertAll(link.delivered(R), 1, 20);
      for (int i = 1; i <= 20; i++) {
        assertEquals(bytes(i, 1 << 20), link.delivered(R).get(i - 1).payload());
      }
      assertEquals(0, reader.statistics(0).incomplete());
      long fragments = 20L * ((1 << 20) / 1356 + 1);
      assertTrue(writer.statistics().repaired() < fragments / 10,
          writer.statistics().repaired() + " of " + fragments + " were sent again");
    }
  }

  @Test
  void aLateReaderGetsWhatWasWritten() {
    LossyLink link = new LossyLink(7, 0.2, 3);
    Qos keeps = LATCHED.withDepth(5);
    WriterCore writer = link.writer(W, keeps);
    for (int i = 1; i <= 12; i++) {
      write(writer, bytes(i, 5000));
    }
    link.reader(R, LATCHED);
    link.match(W, keeps, R, LATCHED);
    link.pass(2000);
    assertAll(link.delivered(R), 8, 12);
    assertEquals(5, writer.statistics().held());
  }

  @Test
  void aVolatileReaderGetsWhatIsWrittenFromThenOn() {
    LossyLink link = new LossyLink(8, 0, 3);
    WriterCore writer = link.writer(W, LATCHED);
    for (int i = 1; i <= 12; i++) {
      write(writer, bytes(i, 50));
    }
    link.reader(R, RELIABLE);
    link.match(W, LATCHED, R, RELIABLE);
    link.pass(100);
    write(writer, bytes(13, 50));
    link.pass(100);
    assertAll(link.delivered(R), 13, 13);
  }

  @Test
  void twoReadersOfOneParticipantGetOneCopy() {
    LossyLink link = new LossyLink(9, 0.1, 2);
    WriterCore writer = link.writer(W, RELIABLE);
    link.reader(R, RELIABLE);
    link.reader(R2, Qos.bestEffort(1));
    link.match(W, RELIABLE, R, RELIABLE);
    link.match(W, RELIABLE, R2, Qos.bestEffort(1));
    link.pass(100);
    for (int i = 1; i <= 200; i++) {
      write(writer, bytes(i, 50));
      link.pass(2);
    }
    link.pass(2000);
    assertAll(link.delivered(R), 1, 200);
    List<Long> best = link.delivered(R2).stream().map(Change::sequence).toList();
    assertEquals(best.stream().sorted().distinct().toList(), best);
    assertTrue(best.size() > 150, best.size() + " of 200");
  }

  @Test
  void bestEffortLosesAndCounts() {
    LossyLink link = new LossyLink(10, 0.1, 2);
    Qos best = Qos.bestEffort(1);
    WriterCore writer = link.writer(W, best);
    ReaderCore reader = link.reader(R, best);
    link.match(W, best, R, best);
    for (int i = 1; i <= 1000; i++) {
      write(writer, bytes(i, i % 10 == 0 ? 4000 : 50));
      link.pass(2);
    }
    link.pass(3000);
    long last = link.delivered(R).getLast().sequence();
    long first = link.delivered(R).getFirst().sequence();
    assertEquals(last - first + 1, link.delivered(R).size() + reader.statistics(0).lost());
    assertTrue(reader.statistics(0).incomplete() > 5);
    assertEquals(0, writer.statistics().held());
  }

  @Test
  void aHistoryThatKeepsAllRefusesWhileAReaderIsSilentAndNoLonger() {
    LossyLink link = new LossyLink(11, 0, 2);
    Qos all = RELIABLE.keepAll();
    WriterCore writer = link.writer(W, all);
    link.reader(R, RELIABLE);
    link.match(W, all, R, RELIABLE);
    link.pass(50);
    link.crash(R);
    int written = 0;
    while (written < 100 && write(writer, bytes(written, 1 << 20)).isPresent()) {
      written++;
    }
    assertEquals(8, written, "8 MiB are held");
    assertEquals(1, writer.statistics().refused());
    writer.unmatch(R);
    assertTrue(write(writer, bytes(1, 1 << 20)).isPresent());
    assertEquals(0, writer.statistics().held());
  }

  @Test
  void whatAReaderLacksWhenItLeftTheHistoryIsToldAsLost() {
    LossyLink link = new LossyLink(12, 0, 2);
    Qos keeps = Qos.reliable(3);
    WriterCore writer = link.writer(W, keeps);
    ReaderCore reader = link.reader(R, keeps);
    link.match(W, keeps, R, keeps);
    link.pass(50);
    write(writer, bytes(1, 50));
    link.pass(50);
    link.cut(true);
    for (int i = 2; i <= 10; i++) {
      write(writer, bytes(i, 50));
    }
    link.pass(5000);
    link.cut(false);
    link.pass(2000);
    assertEquals(List.of(1L, 8L, 9L, 10L), link.delivered(R).stream().map(Change::sequence).toList());
    assertEquals(6, reader.statistics(0).lost());
    assertEquals(6, writer.statistics().unacknowledged());
  }

  @Test
  void aReaderThatForgotUsGetsWhatItAsksFor() {
    LossyLink link = new LossyLink(13, 0, 2);
    WriterCore writer = link.writer(W, LATCHED);
    link.reader(R, LATCHED);
    link.match(W, LATCHED, R, LATCHED);
    write(writer, bytes(1, 50));
    link.pass(100);
    link.crash(R);
    ReaderCore again = link.reader(R, LATCHED);
    again.match(LossyLink.info(W, LATCHED), LossyLink.destination(W));
    link.pass(500);
    assertAll(link.delivered(R), 1, 1);
  }

  @Test
  void acknowledgementIsAwaited() throws InterruptedException {
    LossyLink link = new LossyLink(14, 0, 2);
    WriterCore writer = link.writer(W, RELIABLE);
    link.reader(R, RELIABLE);
    link.match(W, RELIABLE, R, RELIABLE);
    write(writer, bytes(1, 50));
    assertFalse(writer.awaitAcknowledged(Duration.ofMillis(20)));
    link.pass(100);
    assertTrue(writer.awaitAcknowledged(Duration.ofMillis(20)));
  }
}
