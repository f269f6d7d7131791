package org.robotui.rtps.internal.participant;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.Deque;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.function.Consumer;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Sample;
import org.robotui.rtps.internal.endpoint.Destination;
import org.robotui.rtps.internal.endpoint.EndpointOutlet;
import org.robotui.rtps.internal.transport.UdpTransport;
import org.robotui.rtps.internal.wire.DatagramWriter;
import org.robotui.rtps.internal.wire.Submessage;

/** Packs what endpoints say into datagrams. Safe for all threads. */
final class Datagrams implements EndpointOutlet {

  private static final int MOST_IDLE = 4;

  private final GuidPrefix own;
  private final UdpTransport transport;
  private final Consumer<LocalBatch.Said> local;
  private final Map<Integer, Deque<DatagramWriter>> idle = new ConcurrentHashMap<>();

  Datagrams(GuidPrefix own, UdpTransport transport, Consumer<LocalBatch.Said> local) {
    this.local = local;
    this.own = own;
    this.transport = transport;
  }

  @Override
  public Batch to(Destination destination) {
    if (destination.participant().equals(own)) {
      return new LocalBatch(said -> transport.post(() -> said.forEach(local)));
    }
    return new Packing(destination.participant(), destination.mostDatagram(), datagram -> {
      for (InetSocketAddress address : destination.addresses()) {
        transport.send(datagram.duplicate(), address);
      }
    });
  }

  /** One for whoever hears it. */
  Batch toAll(int mostDatagram, Consumer<ByteBuffer> sender) {
    return new Packing(GuidPrefix.UNKNOWN, mostDatagram, sender);
  }

  private Deque<DatagramWriter> idle(int most) {
    return idle.computeIfAbsent(most, none -> new ConcurrentLinkedDeque<>());
  }

  /** One batch. Each datagram names for whom it is, and the time before each sample that has one. */
  private final class Packing extends SubmessageBatch {
    private final GuidPrefix destination;
    private final int most;
    private final Consumer<ByteBuffer> sender;
    private final DatagramWriter writer;
    private long time = Sample.NO_TIME;

    Packing(GuidPrefix destination, int most, Consumer<ByteBuffer> sender) {
      this.destination = destination;
      this.most = most;
      this.sender = sender;
      this.writer =
          Optional.ofNullable(idle(most).pollFirst())
              .orElseGet(() -> new DatagramWriter(own, most, SubmessageBatch.ORDER));
    }

    private void add(Submessage part, long at) {
      if (!fits(part, at)) {
        flush();
        if (!fits(part, at)) {
          throw new IllegalStateException("a datagram of " + most + " bytes is too short for " + part);
        }
      }
    }

    private boolean fits(Submessage part, long at) {
      if (writer.isEmpty()) {
        time = Sample.NO_TIME;
        if (!destination.equals(GuidPrefix.UNKNOWN)) {
          writer.add(new Submessage.InfoDestination(destination));
        }
      }
      if (at != Sample.NO_TIME && at != time) {
        if (!writer.add(new Submessage.InfoTimestamp(at))) {
          return false;
        }
        time = at;
      }
      return writer.add(part);
    }

    private void flush() {
      if (!writer.isEmpty()) {
        sender.accept(writer.finish());
        writer.reset();
      }
    }

    @Override
    public void say(Submessage.Exchanged part, long at) {
      add(part, at);
    }

    @Override
    public void close() {
      flush();
      Deque<DatagramWriter> place = idle(most);
      if (place.size() < MOST_IDLE) {
        place.addFirst(writer);
      }
    }
  }
}
