package org.robotui.ros2;

import org.robotui.rtps.Durability;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.Reader;
import org.robotui.rtps.ReaderStatistics;
import org.robotui.rtps.Sample;
import org.robotui.rtps.SampleListener;

/** A reader of a {@link FakeDomain}. */
final class FakeReader extends FakeEndpoint implements Reader {

  private final SampleListener listener;

  FakeReader(FakeParticipant participant, EndpointInfo info, SampleListener listener) {
    super(participant, info);
    this.listener = listener;
  }

  void catchUp() {
    if (info().qos().durability() == Durability.TRANSIENT_LOCAL) {
      topicEnds().filter(end -> FakeDomain.match(info(), end.info())).map(FakeWriter.class::cast)
          .forEach(writer -> writer.last().ifPresent(this::take));
    }
  }

  void take(Sample sample) {
    participant.receive(() -> listener.received(sample));
  }

  @Override
  public ReaderStatistics statistics() {
    return new ReaderStatistics(0, 0, 0, 0, 0, 0, 0, 0);
  }
}
