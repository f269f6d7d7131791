package org.robotui.lcm.internal.udpm;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.internal.client.Channels;
import org.robotui.lcm.internal.client.Inlet;

/**
 * Makes messages of datagrams.
 *
 * <p>Source: "UDP Multicast Protocol Description" in LCM's documentation.
 */
final class Inbox {

  private final Inlet inlet;
  private final Senders senders;
  private final Reassembly reassembly;

  Inbox(Inlet inlet, LcmOptions options) {
    this.inlet = inlet;
    this.senders = new Senders(inlet.counters());
    this.reassembly = new Reassembly(inlet.counters(), options);
  }

  /** Takes a datagram; whatever it is, it is delivered, kept within the bounds, or counted. */
  synchronized void accept(InetSocketAddress from, ByteBuffer datagram, long now) {
    try {
      int magic = datagram.remaining() < Wire.SHORT_HEADER ? 0 : datagram.getInt(datagram.position());
      switch (magic) {
        case Wire.SHORT -> shortMessage(from, datagram, now);
        case Wire.FRAGMENT -> fragment(from, datagram, now);
        default -> throw new DatagramException("no datagram of LCM: " + datagram.remaining() + " bytes");
      }
    } catch (DatagramException e) {
      inlet.counters().damaged("from " + Senders.name(from) + ": " + e.getMessage());
    }
  }

  private void shortMessage(InetSocketAddress from, ByteBuffer datagram, long now) throws DatagramException {
    int sequence = datagram.getInt(datagram.position() + Integer.BYTES);
    datagram.position(datagram.position() + Wire.SHORT_HEADER);
    String channel = channel(datagram);
    senders.heard(from, sequence);
    if (inlet.wants(channel)) {
      byte[] data = new byte[datagram.remaining()];
      datagram.get(data);
      deliver(from, channel, ByteBuffer.wrap(data), now);
    }
  }

  private void fragment(InetSocketAddress from, ByteBuffer datagram, long now) throws DatagramException {
    Fragment fragment = Fragment.read(datagram);
    Optional<String> channel = fragment.number() == 0 ? Optional.of(channel(datagram)) : Optional.empty();
    reassembly.expire(now);
    Reassembly.Key key = new Reassembly.Key(from, fragment.sequence());
    if (!reassembly.knows(key)) {
      senders.heard(from, fragment.sequence());
    }
    Optional<Partial> complete =
        reassembly.add(key, fragment, datagram, channel, channel.map(inlet::wants).orElse(true), now);
    complete.filter(Partial::isWanted).ifPresent(partial -> deliver(from, partial.channel(), partial.data(), now));
  }

  private static String channel(ByteBuffer datagram) throws DatagramException {
    int most = Math.min(datagram.remaining(), Channels.MOST_BYTES + 1);
    byte[] name = new byte[most];
    datagram.get(datagram.position(), name);
    for (int i = 0; i < most; i++) {
      if (name[i] == 0 && i > 0) {
        datagram.position(datagram.position() + i + 1);
        return new String(name, 0, i, StandardCharsets.UTF_8);
      }
      if (name[i] == 0) {
        break;
      }
    }
    throw new DatagramException("a channel has 1 to " + Channels.MOST_BYTES + " bytes and a zero, this one has not");
  }

  private void deliver(InetSocketAddress from, String channel, ByteBuffer data, long now) {
    long utime = TimeUnit.MILLISECONDS.toMicros(System.currentTimeMillis());
    inlet.deliver(new LcmMessage(channel, data, senders.nameOf(from), now, utime));
  }

  /** Gives up messages that wait too long. */
  synchronized void expire(long now) {
    reassembly.expire(now);
  }
}
