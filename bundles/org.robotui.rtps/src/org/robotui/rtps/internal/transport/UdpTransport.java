package org.robotui.rtps.internal.transport;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.atomic.LongAdder;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.socket.Sockets;
import org.robotui.rtps.Locator;
import org.robotui.rtps.Locators;
import org.robotui.rtps.ParticipantSettings;
import org.robotui.rtps.internal.discovery.Ports;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Datagrams of one participant. Any thread may send; one receives. */
public final class UdpTransport implements Closeable {

  private static final Logger LOG = LoggerFactory.getLogger(UdpTransport.class);
  private static final int LARGEST = 1 << 16;
  /** So many of one socket are taken before others have their turn. */
  private static final int TURN = 64;
  private static final int MOST_POSTED = 4096;

  private final UdpSockets sockets;
  private final Addresses addresses;
  private final Ports ports;
  private final Selector selector;
  private final LongAdder sent = new LongAdder();
  private final LongAdder notSent = new LongAdder();
  private final LogThrottle faults = new LogThrottle();
  private final Queue<Runnable> posted = new ArrayBlockingQueue<>(MOST_POSTED);

  /** Takes what comes, on the receiving thread. */
  @FunctionalInterface
  public interface Receiver {

    /** Takes a datagram; its buffer is used again afterwards. */
    void received(InetSocketAddress from, ByteBuffer datagram);
  }

  private UdpTransport(UdpSockets sockets, Addresses addresses, Ports ports, Selector selector) {
    this.sockets = sockets;
    this.addresses = addresses;
    this.ports = ports;
    this.selector = selector;
  }

  /** Opens the sockets. */
  public static UdpTransport open(ParticipantSettings settings, Addresses addresses) throws IOException {
    UdpSockets sockets = UdpSockets.open(settings, addresses);
    try {
      Selector selector = Selector.open();
      for (DatagramChannel channel : sockets.receiving()) {
        channel.register(selector, SelectionKey.OP_READ);
      }
      return new UdpTransport(sockets, addresses, new Ports(settings.domain()), selector);
    } catch (IOException e) {
      sockets.close();
      throw e;
    }
  }

  /** Where the built-in endpoints are reached. */
  public Locators discovery() {
    Locator group = Locator.udp(Ports.group(), ports.metatrafficMulticast());
    return new Locators(unicast(ports.metatrafficUnicast(sockets.participant())),
        sockets.groupSenders().isEmpty() ? List.of() : List.of(group));
  }

  /** Where the others are. */
  public Locators user() {
    return new Locators(unicast(ports.userUnicast(sockets.participant())), List.of());
  }

  private List<Locator> unicast(int port) {
    return addresses.announced().stream().map(each -> Locator.udp(each, port)).toList();
  }

  /** Sends a datagram to one address. */
  public void send(ByteBuffer datagram, InetSocketAddress to) {
    send(sockets.sender(), datagram, to);
  }

  /** Sends a datagram to the group of the domain, on all interfaces. */
  public void sendToGroup(ByteBuffer datagram) {
    InetSocketAddress group = new InetSocketAddress(Ports.group(), ports.metatrafficMulticast());
    sockets.groupSenders().forEach(each -> send(each, datagram.duplicate(), group));
  }

  private void send(DatagramChannel channel, ByteBuffer datagram, InetSocketAddress to) {
    try {
      boolean taken = channel.send(datagram, to) > 0;
      (taken ? sent : notSent).increment();
    } catch (IOException e) {
      notSent.increment();
      if (channel.isOpen() && faults.admit()) {
        LOG.warn("cannot send to {}: {} ({} times)", to, e.getMessage(), faults.count());
      }
    }
  }

  /** Receives until it is closed. */
  public void receive(Receiver receiver) {
    ByteBuffer buffer = ByteBuffer.allocateDirect(LARGEST);
    try {
      while (selector.isOpen()) {
        selector.select(key -> receive((DatagramChannel) key.channel(), buffer, receiver));
        for (Runnable next = posted.poll(); next != null; next = posted.poll()) {
          next.run();
        }
      }
    } catch (ClosedSelectorException e) {
      LOG.debug("no more is received");
    } catch (IOException e) {
      LOG.error("no more is received", e);
    }
  }

  private void receive(DatagramChannel channel, ByteBuffer buffer, Receiver receiver) {
    try {
      for (int i = 0; i < TURN; i++) {
        buffer.clear();
        InetSocketAddress from = (InetSocketAddress) channel.receive(buffer);
        if (from == null) {
          return;
        }
        if (!addresses.loopbackOnly() || addresses.isOwn(from.getAddress())) {
          taken(receiver, from, buffer.flip());
        }
      }
    } catch (IOException e) {
      // a datagram that could not be delivered comes back as an error; what it meant is told by silence
      LOG.debug("while receiving: {}", e.getMessage());
    }
  }

  /** Whatever a datagram does to who takes it, others come. */
  private void taken(Receiver receiver, InetSocketAddress from, ByteBuffer datagram) {
    try {
      receiver.received(from, datagram);
    } catch (RuntimeException | LinkageError | AssertionError | StackOverflowError e) {
      if (faults.admit()) {
        LOG.error("a datagram from {} could not be taken ({} faults so far)", from, faults.count(), e);
      }
    }
  }

  /** Does something on the receiving thread, or not at all where too much waits there already. */
  public void post(Runnable work) {
    if (posted.offer(work)) {
      selector.wakeup();
    } else {
      notSent.increment();
    }
  }

  /** The datagrams that were sent. */
  public long sent() {
    return sent.sum();
  }

  /** Those that the network did not take. */
  public long notSent() {
    return notSent.sum();
  }

  /** The smallest receive buffer that the system granted. */
  public int receiveBuffer() {
    int least = Integer.MAX_VALUE;
    for (DatagramChannel channel : sockets.receiving()) {
      try {
        least = Math.min(least, channel.getOption(StandardSocketOptions.SO_RCVBUF));
      } catch (IOException e) {
        LOG.debug("the socket is closed", e);
      }
    }
    return least;
  }

  @Override
  public void close() {
    Sockets.closeQuietly(selector);
    sockets.close();
  }
}
