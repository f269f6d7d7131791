package org.robotui.ros2;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalLong;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.Sample;
import org.robotui.rtps.SampleIdentity;
import org.robotui.rtps.Writer;
import org.robotui.rtps.WriterStatistics;

/** A writer of a {@link FakeDomain}. */
final class FakeWriter extends FakeEndpoint implements Writer {

  private long sequence;
  private long awaited;
  private Optional<Sample> last = Optional.empty();

  FakeWriter(FakeParticipant participant, EndpointInfo info) {
    super(participant, info);
  }

  synchronized Optional<Sample> last() {
    return last;
  }

  @Override
  public OptionalLong write(ByteBuffer payload) {
    return write(payload, Optional.empty());
  }

  @Override
  public OptionalLong write(ByteBuffer payload, SampleIdentity related) {
    return write(payload, Optional.of(related));
  }

  private synchronized OptionalLong write(ByteBuffer payload, Optional<SampleIdentity> related) {
    Sample sample = new Sample(FakeDomain.copy(payload), Sample.Kind.ALIVE, info().guid(), ++sequence,
        System.currentTimeMillis() * 1_000_000, related, System.nanoTime());
    last = Optional.of(sample);
    topicEnds().filter(end -> FakeDomain.match(info(), end.info())).map(FakeReader.class::cast)
        .forEach(reader -> reader.take(sample));
    return OptionalLong.of(sequence);
  }

  @Override
  public void assertLiveliness() {
    throw new UnsupportedOperationException("nobody watches here");
  }

  /** Up to which sample its writer has waited for all to have it. */
  synchronized long awaited() {
    return awaited;
  }

  @Override
  public synchronized boolean awaitAcknowledged(Duration timeout) {
    awaited = sequence;
    return true;
  }

  @Override
  public WriterStatistics statistics() {
    return new WriterStatistics(sequence, 0, 0, 0, 0, 0, 0);
  }
}
