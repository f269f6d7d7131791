package org.robotui.rtps.internal.participant;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.Sample;
import org.robotui.rtps.internal.discovery.BuiltIn;
import org.robotui.rtps.internal.discovery.EndpointCodec;
import org.robotui.rtps.internal.discovery.ParticipantCodec;
import org.robotui.rtps.internal.endpoint.Change;
import org.robotui.rtps.internal.endpoint.Destination;
import org.robotui.rtps.internal.endpoint.EndpointOutlet;
import org.robotui.rtps.internal.endpoint.SourceClock;
import org.robotui.rtps.internal.transport.UdpTransport;

/** Says that this participant is there: often at first, as one may get lost, and then in every period. */
final class Announcer {

  private static final int MOST_DATAGRAM = 8_192;
  private static final long FIRST_PAUSE = Duration.ofMillis(100).toNanos();

  private final Datagrams datagrams;
  private final UdpTransport transport;
  private final List<InetSocketAddress> peers;
  private final long period;
  private final Change present;
  private final Change gone;
  private long pause = FIRST_PAUSE;

  Announcer(ParticipantInfo info, Duration period, Datagrams datagrams, UdpTransport transport,
      List<InetSocketAddress> peers) {
    this.datagrams = datagrams;
    this.transport = transport;
    this.peers = peers;
    this.period = period.toNanos();
    ByteBuffer payload = ParticipantCodec.write(info, ByteOrder.LITTLE_ENDIAN);
    this.present =
        new Change(1, Sample.Kind.ALIVE, payload, Sample.NO_TIME, Optional.empty(), Optional.of(info.guid()));
    this.gone = new Change(2, Sample.Kind.DISPOSED, EndpointCodec.writeKey(info.guid(), ByteOrder.LITTLE_ENDIAN),
        Sample.NO_TIME, Optional.empty(), Optional.of(info.guid()));
  }

  /** Says it to all, and when it is to be said next. */
  long announce(long now) {
    toAll(present);
    long next = now + Math.min(pause, period);
    pause = Math.min(period, pause * 3);
    return next;
  }

  /** Says it to one who has just come. */
  void announceTo(Destination destination) {
    try (EndpointOutlet.Batch batch = datagrams.to(destination)) {
      send(batch, present);
    }
  }

  /** Says that it goes. */
  void farewell(List<Destination> known) {
    toAll(gone);
    for (Destination each : known) {
      try (EndpointOutlet.Batch batch = datagrams.to(each)) {
        send(batch, gone);
      }
    }
  }

  private void toAll(Change change) {
    try (EndpointOutlet.Batch batch = datagrams.toAll(MOST_DATAGRAM, this::sendToAll)) {
      send(batch, change);
    }
  }

  private static void send(EndpointOutlet.Batch batch, Change change) {
    batch.data(EntityId.UNKNOWN, BuiltIn.PARTICIPANT_WRITER, new Change(change.sequence(), change.kind(),
        change.payload(), SourceClock.nanos(), change.related(), change.instance()));
  }

  private void sendToAll(ByteBuffer datagram) {
    transport.sendToGroup(datagram.duplicate());
    peers.forEach(each -> transport.send(datagram.duplicate(), each));
  }
}
