package org.robotui.rtps.internal.participant;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.Function;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.log.PeerText;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Guid;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Sample;
import org.robotui.rtps.internal.discovery.BuiltIn;
import org.robotui.rtps.internal.endpoint.Change;
import org.robotui.rtps.internal.endpoint.Fragments;
import org.robotui.rtps.internal.endpoint.ReaderCore;
import org.robotui.rtps.internal.endpoint.WriterCore;
import org.robotui.rtps.internal.wire.InlineQos;
import org.robotui.rtps.internal.wire.MessageContext;
import org.robotui.rtps.internal.wire.MessageHandler;
import org.robotui.rtps.internal.wire.DatagramReader;
import org.robotui.rtps.internal.wire.Submessage;
import org.robotui.rtps.internal.wire.WireException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Gives what datagrams say to the ends that it is for. For the receiving thread. */
final class DatagramInlet implements MessageHandler {

  private static final Logger LOG = LoggerFactory.getLogger(DatagramInlet.class);
  private static final ByteBuffer NOTHING = ByteBuffer.allocate(0).asReadOnlyBuffer();

  private final Switchboard switchboard;
  private final Meeting meeting;
  private final DatagramReader reader;
  private final GuidPrefix own;
  private final LongAdder datagrams = new LongAdder();
  private final LongAdder bytes = new LongAdder();
  private final LongAdder damaged = new LongAdder();
  private final LongAdder ignored = new LongAdder();
  private final LogThrottle damages = new LogThrottle();
  private volatile String lastDamage = "";
  private InetAddress host = InetAddress.getLoopbackAddress();

  DatagramInlet(GuidPrefix own, Switchboard switchboard, Meeting meeting) {
    this.own = own;
    this.switchboard = switchboard;
    this.meeting = meeting;
    this.reader = new DatagramReader(own);
  }

  /** Takes a datagram. */
  void datagram(InetSocketAddress from, ByteBuffer datagram) {
    datagrams.increment();
    bytes.add(datagram.remaining());
    host = from.getAddress();
    try {
      reader.read(datagram, this);
    } catch (WireException e) {
      damaged("from " + from + ": " + e.getMessage());
    }
    if (reader.context().source().equals(own)) {
      ignored.increment();
    } else {
      meeting.heard(reader.context().source());
    }
  }

  private void damaged(String what) {
    damaged.increment();
    lastDamage = PeerText.brief(what);
    if (damages.admit()) {
      LOG.warn("a damaged message {} ({} so far)", lastDamage, damages.count());
    }
  }

  @Override
  public void onPart(MessageContext context, Submessage.Exchanged part) {
    part(context.source(), context.timestamp(), part);
  }

  /** Takes what one of our own ends says to another one. */
  void own(LocalBatch.Said said) {
    part(own, said.time(), said.part());
  }

  private void part(GuidPrefix source, long time, Submessage.Exchanged part) {
    Guid writer = new Guid(source, part.writer());
    Guid reading = new Guid(source, part.reader());
    switch (part) {
      case Submessage.Data data -> data(writer, data, time);
      case Submessage.DataFrag fragment -> fragment(writer, fragment, time);
      case Submessage.Heartbeat beat -> toReaders(writer, beat.reader(),
          core -> core.heartbeat(writer, beat.first(), beat.last(), !beat.finalFlag(), beat.liveliness()));
      case Submessage.Gap gap -> toReaders(writer, gap.reader(), core -> core.gap(writer, gap.start(), gap.set()));
      case Submessage.AckNack ack -> writer(part)
          .ifPresent(core -> core.acknowledged(reading, ack.missing(), !ack.finalFlag()));
      case Submessage.NackFrag nack -> writer(part)
          .ifPresent(core -> core.lacks(reading, nack.sequence(), nack.missing()));
      case Submessage.HeartbeatFrag beat -> {
        // what lacks is asked for by what came, and by time
      }
    }
  }

  private Optional<WriterCore> writer(Submessage.Exchanged part) {
    return switchboard.writer(part.writer());
  }

  private void data(Guid writer, Submessage.Data data, long time) {
    if (data.writer().equals(BuiltIn.PARTICIPANT_WRITER)) {
      announced(writer.prefix(), data);
      return;
    }
    List<ReaderPort> listening = switchboard.listening(writer);
    if (!listening.isEmpty()) {
      qos(writer, data.inlineQos()).ifPresent(qos -> {
        Change change = new Change(data.sequence(), kind(qos), copy(data.payload()), time, qos.related(), qos.key());
        toReaders(listening, writer, data.reader(), core -> core.data(writer, change));
      });
    }
  }

  private void announced(GuidPrefix source, Submessage.Data data) {
    qos(new Guid(source, data.writer()), data.inlineQos()).ifPresent(qos -> {
      try {
        meeting.participant(source, host, kind(qos), data.payload(), qos.key());
      } catch (WireException e) {
        damaged("from " + source + " at " + host.getHostAddress() + ", its announcement: " + e.getMessage());
      }
    });
  }

  private Optional<InlineQos> qos(Guid writer, ByteBuffer list) {
    try {
      return Optional.of(InlineQos.read(list));
    } catch (WireException e) {
      damaged("from " + writer + ", what stands beside a sample: " + e.getMessage());
      return Optional.empty();
    }
  }

  private static Sample.Kind kind(InlineQos qos) {
    Sample.Kind gone = qos.unregistered() ? Sample.Kind.UNREGISTERED : Sample.Kind.ALIVE;
    return qos.disposed() ? Sample.Kind.DISPOSED : gone;
  }

  private static ByteBuffer copy(ByteBuffer payload) {
    byte[] bytes = new byte[payload.remaining()];
    payload.get(payload.position(), bytes);
    return ByteBuffer.wrap(bytes).asReadOnlyBuffer();
  }

  private void fragment(Guid writer, Submessage.DataFrag part, long time) {
    List<ReaderPort> listening = switchboard.listening(writer);
    if (!listening.isEmpty()) {
      qos(writer, part.inlineQos()).ifPresent(qos -> {
        Change about = new Change(part.sequence(), kind(qos), NOTHING, time, qos.related(), qos.key());
        Fragments fragments = new Fragments(part.first(), part.count(), part.fragmentSize(), part.sampleSize(), about,
            part.payload());
        toReaders(listening, writer, part.reader(), core -> core.fragments(writer, fragments));
      });
    }
  }

  private void toReaders(Guid writer, EntityId meant, Function<ReaderCore, List<Change>> action) {
    toReaders(switchboard.listening(writer), writer, meant, action);
  }

  private static void toReaders(List<ReaderPort> listening, Guid writer, EntityId meant,
      Function<ReaderCore, List<Change>> action) {
    for (ReaderPort port : listening) {
      if (meant.equals(EntityId.UNKNOWN) || meant.equals(port.entity())) {
        List<Change> inOrder = action.apply(port.core());
        if (!inOrder.isEmpty()) {
          port.deliver(writer, inOrder);
        }
      }
    }
  }

  /** What a reader could not read. */
  void refused(String what) {
    damaged(what);
  }

  long datagrams() {
    return datagrams.sum();
  }

  long bytes() {
    return bytes.sum();
  }

  long damagedOnes() {
    return damaged.sum();
  }

  long ignored() {
    return ignored.sum();
  }

  String lastDamage() {
    return lastDamage;
  }
}
