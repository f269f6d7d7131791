package org.robotui.rtps.internal.endpoint;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.Guid;
import org.robotui.rtps.Liveliness;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Sample;

/** The times that readers ask for, by a clock of the test. */
class WriterWatchTest {

  private static final Guid W = LossyLink.guid(1, 1, EndpointKind.WRITER);
  private static final Guid R = LossyLink.guid(2, 1, EndpointKind.READER);

  private final LossyLink link = new LossyLink(1, 0, 1);

  private ReaderCore match(Qos qos) {
    link.writer(W, qos);
    ReaderCore reader = link.reader(R, qos);
    link.match(W, qos, R, qos);
    return reader;
  }

  @Test
  void eachDeadlineThatPassesIsCounted() {
    Qos qos = Qos.bestEffort(1).withTimes(Duration.ofMillis(100), Qos.INFINITE);
    ReaderCore reader = match(qos);
    for (int i = 1; i <= 10; i++) {
      reader.data(W, new Change(i, Sample.Kind.ALIVE, ByteBuffer.allocate(8), 0, Optional.empty(), Optional.empty()));
      link.pass(50);
    }
    assertEquals(0, reader.statistics(0).deadlinesMissed());
    link.pass(300);
    assertEquals(3, reader.statistics(0).deadlinesMissed());
  }

  @Test
  void aWriterThatIsNotAliveIsCountedOnceUntilItIsAgain() {
    Qos qos = Qos.bestEffort(1).with(Liveliness.AUTOMATIC, Duration.ofMillis(200));
    ReaderCore reader = match(qos);
    link.pass(900);
    assertEquals(1, reader.statistics(0).livelinessLost());
    reader.alive(W.prefix(), Liveliness.MANUAL_BY_PARTICIPANT);
    link.pass(900);
    assertEquals(1, reader.statistics(0).livelinessLost(), "that is another kind");
    for (int i = 0; i < 10; i++) {
      reader.alive(W.prefix(), Liveliness.AUTOMATIC);
      link.pass(100);
    }
    assertEquals(1, reader.statistics(0).livelinessLost());
    link.pass(900);
    assertEquals(2, reader.statistics(0).livelinessLost());
  }
}
