package org.robotui.rtps.internal.endpoint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.Guid;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Sample;

/** Large changes on their way to readers with small buffers. */
class PacedChangesTest {

  private static final Guid W = LossyLink.guid(1, 1, EndpointKind.WRITER);
  private static final Guid R = LossyLink.guid(2, 1, EndpointKind.READER);
  private static final int LARGE = 1 << 20;

  private final LossyLink link = new LossyLink(15, 0, 1);

  private WriterCore matched(Qos qos) {
    WriterCore writer = link.writer(W, qos);
    link.reader(R, qos);
    link.match(W, qos, R, qos);
    link.pass(50);
    return writer;
  }

  private static ByteBuffer write(WriterCore writer, int size) {
    byte[] bytes = new byte[size];
    new Random(size).nextBytes(bytes);
    ByteBuffer payload = ByteBuffer.wrap(bytes);
    assertTrue(writer.write(Sample.Kind.ALIVE, payload, 1, Optional.empty(), Optional.empty()).isPresent());
    return payload;
  }

  private void assertDelivered(long last) {
    assertEquals(LongStream.rangeClosed(1, last).boxed().toList(),
        link.delivered(R).stream().map(Change::sequence).toList());
  }

  @Test
  void aSmallBufferLosesNothingOfWhatIsNotSentAgain() {
    link.buffer(3 * PacedChanges.TURN);
    WriterCore writer = matched(Qos.bestEffort(1));
    List<ByteBuffer> written = List.of(write(writer, LARGE), write(writer, 50), write(writer, LARGE / 2));
    link.pass(30);
    assertDelivered(3);
    assertEquals(written, link.delivered(R).stream().map(Change::payload).toList());
  }

  @Test
  void reliableReadersAreNotAskedForWhatIsOnItsWay() {
    link.buffer(3 * PacedChanges.TURN);
    WriterCore writer = matched(Qos.reliable(100));
    for (int i = 0; i < 20; i++) {
      write(writer, LARGE);
      link.pass(15);
    }
    link.pass(100);
    assertDelivered(20);
    assertEquals(0, writer.statistics().repaired());
    assertEquals(0, writer.statistics().held());
  }

  @Test
  void whatWaitsIsSentBeforeAWriterCloses() {
    WriterCore writer = matched(Qos.bestEffort(1));
    write(writer, LARGE);
    writer.close();
    link.pass(5);
    assertDelivered(1);
  }

  @Test
  void whoWritesFasterThanTurnsGoDoesNotWaitForThem() {
    WriterCore writer = matched(Qos.reliable(100));
    for (int i = 0; i < 12; i++) {
      write(writer, LARGE);
    }
    link.pass(2);
    assertTrue(link.delivered(R).size() >= 8, link.delivered(R).size() + " came");
    link.pass(60);
    assertDelivered(12);
  }

  @Test
  void aReaderThatHasGoneGetsNoMore() {
    WriterCore writer = matched(Qos.bestEffort(1));
    write(writer, LARGE);
    writer.unmatch(R);
    link.pass(30);
    assertDelivered(0);
  }
}
