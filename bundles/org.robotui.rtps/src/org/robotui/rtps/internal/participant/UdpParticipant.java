package org.robotui.rtps.internal.participant;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.net.log.PeerText;
import org.robotui.net.thread.Workers;
import org.robotui.rtps.Discovery;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Participant;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.ParticipantSettings;
import org.robotui.rtps.ParticipantStatistics;
import org.robotui.rtps.ProtocolVersion;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Reader;
import org.robotui.rtps.SampleListener;
import org.robotui.rtps.VendorId;
import org.robotui.rtps.Writer;
import org.robotui.rtps.internal.discovery.BuiltIn;
import org.robotui.rtps.internal.discovery.DiscoveredParticipants;
import org.robotui.rtps.internal.endpoint.ReaderCore;
import org.robotui.rtps.internal.endpoint.Timers;
import org.robotui.rtps.internal.endpoint.WriterCore;
import org.robotui.rtps.internal.transport.Addresses;
import org.robotui.rtps.internal.transport.Routes;
import org.robotui.rtps.internal.transport.UdpTransport;

/** Joins the parts of a participant, and gives them their threads. */
public final class UdpParticipant implements Participant {

  private static final long ENDING = Duration.ofMillis(500).toNanos();

  private final ParticipantSettings settings;
  private final ParticipantInfo info;
  private final UdpTransport transport;
  private final Timers timers = new Timers(Timers.Clock.system());
  private final AtomicInteger counts = new AtomicInteger();
  private final AtomicInteger entities = new AtomicInteger();
  private final Switchboard switchboard = new Switchboard();
  private final AtomicBoolean closed = new AtomicBoolean();
  private final DiscoveredParticipants discovered;
  private final Peers peers;
  private final Datagrams datagrams;
  private final Announcer announcer;
  private final BuiltIns builtIns;
  private final Matching matching;
  private final DatagramInlet inlet;
  private final Workers workers;

  private UdpParticipant(ParticipantSettings settings, ThreadFactory threads, Addresses addresses,
      UdpTransport transport, List<InetSocketAddress> asked) {
    this.settings = settings;
    this.transport = transport;
    this.info = new ParticipantInfo(Guid.participant(randomPrefix()), VendorId.UNKNOWN, ProtocolVersion.V2_3,
        settings.name(), OptionalInt.of(settings.domain()), settings.lease(), BuiltIn.OURS, transport.discovery(),
        transport.user(), settings.userData());
    GuidPrefix own = info.guid().prefix();
    this.discovered = new DiscoveredParticipants(settings.domain(), settings.limits());
    this.peers = new Peers(new Routes(addresses));
    this.datagrams = new Datagrams(own, transport, this::own);
    this.announcer = new Announcer(info, settings.announcePeriod(), datagrams, transport, asked);
    Attention attention = new Attention(timers);
    Meeting meeting = new Meeting(discovered, peers, attention);
    this.builtIns = new BuiltIns(own, switchboard, settings.limits(), timers, datagrams, counts, meeting);
    this.matching = new Matching(discovered, peers, builtIns);
    this.inlet = new DatagramInlet(own, switchboard, meeting);
    this.workers = new Workers(threads);
    meeting.begin(new Meeting.Parts(builtIns, announcer, matching));
    new Upkeep(timers, attention, discovered, announcer, builtIns, matching).start();
  }

  private void own(LocalBatch.Said said) {
    inlet.own(said);
  }

  /** Opens the sockets and starts the threads. */
  public static UdpParticipant open(ParticipantSettings settings, ThreadFactory threads) throws IOException {
    Addresses addresses = Addresses.of(settings.interfaces());
    List<InetSocketAddress> asked = AskedAddresses.of(settings, addresses);
    UdpTransport transport = UdpTransport.open(settings, addresses);
    UdpParticipant participant = new UdpParticipant(settings, threads, addresses, transport, asked);
    try {
      participant.start();
    } catch (RuntimeException | Error e) {
      participant.close();
      throw e;
    }
    return participant;
  }

  private void start() {
    String name = "rtps " + PeerText.name(settings.name()) + " " + settings.domain();
    workers.start(name + " receiving", () -> transport.receive(inlet::datagram));
    workers.start(name + " timers", this::runTimers);
  }

  private void runTimers() {
    try {
      while (timers.await()) {
        timers.runDue();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Two bytes of the vendor, which is nobody, and ten that nobody else has. */
  private static GuidPrefix randomPrefix() {
    SecureRandom random = new SecureRandom();
    return new GuidPrefix(random.nextLong() & 0xffff_ffff_ffffL | 1, random.nextInt());
  }

  @Override
  public ParticipantInfo info() {
    return info;
  }

  @Override
  public Discovery discovery() {
    return new DiscoveryView(discovered);
  }

  private EndpointInfo endpoint(EndpointKind kind, String topic, String type, Qos qos, ByteBuffer userData) {
    EntityId entity = EntityId.user(entities.incrementAndGet(), kind, false);
    return new EndpointInfo(new Guid(info.guid().prefix(), entity), kind, topic, type, qos, userData,
        info.userTraffic(), false);
  }

  @Override
  public Reader reader(String topic, String type, Qos qos, ByteBuffer userData, SampleListener listener) {
    EndpointInfo about = endpoint(EndpointKind.READER, topic, type, qos, userData);
    ReaderCore core = new ReaderCore(about.guid(), qos, settings.limits(), timers, datagrams, counts);
    LocalReader reader = new LocalReader(about, matching, switchboard, core, listener);
    matching.add(reader);
    return reader;
  }

  @Override
  public Reader adaptingReader(String topic, String type, Qos preferred, ByteBuffer userData,
      SampleListener listener) {
    return AdaptingReader.open(topic, type, preferred, discovered,
        (qos, taker) -> reader(topic, type, qos, userData, taker), listener);
  }

  @Override
  public Writer writer(String topic, String type, Qos qos, ByteBuffer userData) {
    EndpointInfo about = endpoint(EndpointKind.WRITER, topic, type, qos, userData);
    WriterCore core =
        new WriterCore(about.guid(), qos, settings.limits().cacheBytes(), timers, datagrams, counts);
    LocalWriter writer = new LocalWriter(about, matching, switchboard, core, settings.limits().sampleBytes());
    matching.add(writer);
    return writer;
  }

  @Override
  public ParticipantStatistics statistics() {
    return new ParticipantStatistics(inlet.datagrams(), inlet.bytes(), inlet.damagedOnes(), inlet.ignored(),
        transport.sent(), transport.notSent(), transport.receiveBuffer(), inlet.lastDamage());
  }

  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      matching.close();
      announcer.farewell(discovered.participants().stream()
          .flatMap(each -> peers.builtIn(each.guid().prefix()).stream()).toList());
      timers.close();
      builtIns.close();
      transport.close();
    }
    workers.join(System.nanoTime() + ENDING);
  }
}
