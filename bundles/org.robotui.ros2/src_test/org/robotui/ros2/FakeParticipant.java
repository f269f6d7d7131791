package org.robotui.ros2;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.rtps.Discovery;
import org.robotui.rtps.DiscoveryListener;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Locators;
import org.robotui.rtps.Participant;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.ParticipantStatistics;
import org.robotui.rtps.ProtocolVersion;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Reader;
import org.robotui.rtps.SampleListener;
import org.robotui.rtps.VendorId;
import org.robotui.rtps.Writer;

/** One participant of a {@link FakeDomain}; its thread stands for the one that receives. */
final class FakeParticipant implements Participant, Discovery {

  private static final Locators NOWHERE = new Locators(List.of(), List.of());

  final List<FakeEndpoint> endpoints = new CopyOnWriteArrayList<>();
  final ExecutorService receiving = Executors.newSingleThreadExecutor();
  private final FakeDomain domain;
  private final ParticipantInfo info;
  private final List<DiscoveryListener> listeners = new CopyOnWriteArrayList<>();
  private final AtomicInteger keys = new AtomicInteger();

  FakeParticipant(FakeDomain domain, int number, VendorId vendor) {
    this.domain = domain;
    this.info = new ParticipantInfo(Guid.participant(new GuidPrefix(0x010f000000000000L, number)), vendor,
        new ProtocolVersion(2, 3), "", OptionalInt.of(0), Duration.ofSeconds(10), 0, NOWHERE, NOWHERE,
        ByteBuffer.allocate(0));
  }

  FakeDomain domain() {
    return domain;
  }

  /** Runs on the receiving thread; after the end nothing is heard. */
  void receive(Runnable work) {
    if (!receiving.isShutdown()) {
      receiving.execute(work);
    }
  }

  @Override
  public ParticipantInfo info() {
    return info;
  }

  @Override
  public Discovery discovery() {
    return this;
  }

  private <E extends FakeEndpoint> E announce(E end) {
    endpoints.add(end);
    domain.others(this)
        .forEach(other -> other.receive(() -> other.listeners.forEach(l -> l.endpointFound(end.info()))));
    return end;
  }

  void leave(FakeEndpoint end) {
    endpoints.remove(end);
    domain.others(this)
        .forEach(other -> other.receive(() -> other.listeners.forEach(l -> l.endpointLost(end.info(), "closed"))));
  }

  private EndpointInfo end(EndpointKind kind, String topic, String type, Qos qos, ByteBuffer userData) {
    Guid guid = new Guid(info.guid().prefix(), EntityId.user(keys.incrementAndGet(), kind, false));
    return new EndpointInfo(guid, kind, topic, type, qos, userData, NOWHERE, false);
  }

  @Override
  public Reader reader(String topic, String type, Qos qos, ByteBuffer userData, SampleListener listener) {
    FakeReader made = announce(new FakeReader(this, end(EndpointKind.READER, topic, type, qos, userData), listener));
    made.catchUp();
    return made;
  }

  @Override
  public Reader adaptingReader(String topic, String type, Qos preferred, ByteBuffer userData,
      SampleListener listener) {
    return reader(topic, type, Qos.bestEffort(preferred.depth()), userData, listener);
  }

  @Override
  public Writer writer(String topic, String type, Qos qos, ByteBuffer userData) {
    return announce(new FakeWriter(this, end(EndpointKind.WRITER, topic, type, qos, userData)));
  }

  @Override
  public ParticipantStatistics statistics() {
    return new ParticipantStatistics(0, 0, 0, 0, 0, 0, 0, "");
  }

  @Override
  public void close() {
    domain.left(this);
    List.copyOf(endpoints).forEach(this::leave);
    domain.others(this)
        .forEach(other -> other.receive(() -> other.listeners.forEach(l -> l.participantLost(info, "closed"))));
    receiving.shutdown();
  }

  @Override
  public List<ParticipantInfo> participants() {
    return domain.others(this).stream().map(FakeParticipant::info).toList();
  }

  @Override
  public Optional<ParticipantInfo> participant(GuidPrefix prefix) {
    return participants().stream().filter(other -> other.guid().prefix().equals(prefix)).findFirst();
  }

  @Override
  public OptionalLong heardNanos(GuidPrefix prefix) {
    return participant(prefix).isPresent() ? OptionalLong.of(System.nanoTime()) : OptionalLong.empty();
  }

  @Override
  public List<EndpointInfo> endpoints() {
    return domain.others(this).stream().flatMap(other -> other.endpoints.stream()).map(FakeEndpoint::info).toList();
  }

  @Override
  public void addListener(DiscoveryListener listener) {
    participants().forEach(listener::participantFound);
    endpoints().forEach(listener::endpointFound);
    listeners.add(listener);
  }

  @Override
  public void removeListener(DiscoveryListener listener) {
    listeners.remove(listener);
  }
}
