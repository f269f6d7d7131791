package org.robotui.rtps.internal.participant;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.rtps.Durability;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.ParticipantLimits;
import org.robotui.rtps.Locators;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Sample;
import org.robotui.rtps.internal.discovery.BuiltIn;
import org.robotui.rtps.internal.discovery.EndpointCodec;
import org.robotui.rtps.internal.endpoint.Change;
import org.robotui.rtps.internal.endpoint.Destination;
import org.robotui.rtps.internal.endpoint.EndpointOutlet;
import org.robotui.rtps.internal.endpoint.ReaderCore;
import org.robotui.rtps.internal.endpoint.Timers;
import org.robotui.rtps.internal.endpoint.SourceClock;
import org.robotui.rtps.internal.endpoint.WriterCore;

/** The ends by which participants tell each other of their readers and writers, and that they are alive. */
final class BuiltIns implements Matching.Publishing {

  private static final Qos QOS = Qos.reliable(1).with(Durability.TRANSIENT_LOCAL);
  private static final ByteOrder ORDER = ByteOrder.LITTLE_ENDIAN;

  private final GuidPrefix own;
  private final Switchboard switchboard;
  private final ParticipantLimits limits;
  private final Timers timers;
  private final EndpointOutlet outlet;
  private final AtomicInteger counts;
  private final List<Pair> pairs;

  /** Both ends of a built-in topic, and the bits by which a participant says that it has them. */
  private record Pair(WriterCore writer, Port reader, Ends ends) {}

  /** The names of both ends, and their bits. */
  private record Ends(String topic, EntityId writer, EntityId reader, int hasWriter, int hasReader) {}

  /** Takes what participants say. */
  @FunctionalInterface
  interface Taker {
    void take(Guid writer, Change change);
  }

  /** A built-in reader. */
  private record Port(EntityId entity, ReaderCore core, Taker taker) implements ReaderPort {
    @Override
    public void deliver(Guid writer, List<Change> changes) {
      changes.forEach(change -> taker.take(writer, change));
    }
  }

  BuiltIns(GuidPrefix own, Switchboard switchboard, ParticipantLimits limits, Timers timers, EndpointOutlet outlet,
      AtomicInteger counts, Hearing hearing) {
    this.own = own;
    this.switchboard = switchboard;
    this.limits = limits;
    this.timers = timers;
    this.outlet = outlet;
    this.counts = counts;
    this.pairs = List.of(
        pair(new Ends("DCPSPublication", BuiltIn.PUBLICATIONS_WRITER, BuiltIn.PUBLICATIONS_READER,
            BuiltIn.HAS_PUBLICATIONS_WRITER, BuiltIn.HAS_PUBLICATIONS_READER),
            (writer, change) -> hearing.endpoint(writer, change, EndpointKind.WRITER)),
        pair(new Ends("DCPSSubscription", BuiltIn.SUBSCRIPTIONS_WRITER, BuiltIn.SUBSCRIPTIONS_READER,
            BuiltIn.HAS_SUBSCRIPTIONS_WRITER, BuiltIn.HAS_SUBSCRIPTIONS_READER),
            (writer, change) -> hearing.endpoint(writer, change, EndpointKind.READER)),
        pair(new Ends("DCPSParticipantMessage", BuiltIn.MESSAGE_WRITER, BuiltIn.MESSAGE_READER,
            BuiltIn.HAS_MESSAGE_WRITER, BuiltIn.HAS_MESSAGE_READER), hearing::alive));
  }

  private Pair pair(Ends ends, Taker taker) {
    Guid writer = new Guid(own, ends.writer());
    Guid reader = new Guid(own, ends.reader());
    WriterCore writes = new WriterCore(writer, QOS, limits.cacheBytes(), timers, outlet, counts);
    switchboard.add(ends.writer(), writes);
    Port reads =
        new Port(ends.reader(), new ReaderCore(reader, QOS, limits, timers, outlet, counts), taker);
    return new Pair(writes, reads, ends);
  }

  /** Exchanges what there is with a participant. */
  void connect(ParticipantInfo info, Destination destination) {
    GuidPrefix prefix = info.guid().prefix();
    for (Pair pair : pairs) {
      if ((info.builtInEndpoints() & pair.ends().hasWriter()) != 0) {
        EndpointInfo writer = remote(prefix, pair.ends().writer(), pair.ends().topic(), EndpointKind.WRITER);
        switchboard.connect(writer.guid(), pair.reader());
        pair.reader().core().match(writer, destination);
      }
      if ((info.builtInEndpoints() & pair.ends().hasReader()) != 0) {
        pair.writer().match(remote(prefix, pair.ends().reader(), pair.ends().topic(), EndpointKind.READER),
            destination);
      }
    }
  }

  private static EndpointInfo remote(GuidPrefix prefix, EntityId entity, String topic, EndpointKind kind) {
    return new EndpointInfo(new Guid(prefix, entity), kind, topic, topic, QOS, ByteBuffer.allocate(0), Locators.NONE,
        false);
  }

  /** Ends that. */
  void disconnect(GuidPrefix prefix) {
    for (Pair pair : pairs) {
      Guid writer = new Guid(prefix, pair.ends().writer());
      switchboard.disconnect(writer, pair.reader());
      pair.reader().core().unmatch(writer);
      pair.writer().unmatch(new Guid(prefix, pair.ends().reader()));
    }
  }

  private WriterCore announcing(EndpointInfo endpoint) {
    return pairs.get(endpoint.kind() == EndpointKind.WRITER ? 0 : 1).writer();
  }

  @Override
  public void opened(EndpointInfo endpoint) {
    announcing(endpoint).write(Sample.Kind.ALIVE, EndpointCodec.write(endpoint, ORDER), SourceClock.nanos(),
        Optional.empty(), Optional.of(endpoint.guid()));
  }

  @Override
  public void closed(EndpointInfo endpoint) {
    announcing(endpoint).write(Sample.Kind.DISPOSED, EndpointCodec.writeKey(endpoint.guid(), ORDER),
        SourceClock.nanos(), Optional.empty(), Optional.of(endpoint.guid()));
  }

  /** Says that this participant is alive, for those of its writers that promise it. */
  void sayAlive() {
    pairs.get(2).writer().write(Sample.Kind.ALIVE, AliveMessage.automatic(own), SourceClock.nanos(), Optional.empty(),
        Optional.of(Guid.participant(own)));
  }

  /** Ends all. */
  void close() {
    for (Pair pair : pairs) {
      pair.writer().close();
      pair.reader().core().close();
    }
  }
}
