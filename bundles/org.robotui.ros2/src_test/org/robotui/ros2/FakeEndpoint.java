package org.robotui.ros2;

import java.util.List;
import java.util.stream.Stream;
import org.robotui.rtps.Endpoint;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.MatchListener;
import org.robotui.rtps.Mismatch;
import org.robotui.rtps.Qos;

/** What readers and writers of a {@link FakeDomain} have in common. */
abstract class FakeEndpoint implements Endpoint {

  final FakeParticipant participant;
  private final EndpointInfo info;

  FakeEndpoint(FakeParticipant participant, EndpointInfo info) {
    this.participant = participant;
    this.info = info;
  }

  @Override
  public EndpointInfo info() {
    return info;
  }

  Stream<FakeEndpoint> topicEnds() {
    return participant.domain().others(participant).stream().flatMap(other -> other.endpoints.stream())
        .filter(other -> FakeDomain.sameTopic(info, other.info));
  }

  @Override
  public List<EndpointInfo> matched() {
    return topicEnds().map(FakeEndpoint::info).filter(other -> FakeDomain.match(info, other)).toList();
  }

  @Override
  public List<Mismatch> mismatches() {
    return topicEnds().map(FakeEndpoint::info).filter(other -> !FakeDomain.match(info, other))
        .map(other -> new Mismatch(other, info.kind() == EndpointKind.WRITER
            ? Qos.mismatch(info.qos(), other.qos())
            : Qos.mismatch(other.qos(), info.qos())))
        .toList();
  }

  @Override
  public void addListener(MatchListener listener) {
    matched().forEach(listener::matched);
  }

  @Override
  public void close() {
    participant.leave(this);
  }
}
