package org.robotui.rtps.internal.transport;

import java.io.Closeable;
import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.channels.DatagramChannel;
import java.util.ArrayList;
import java.util.List;
import org.robotui.net.socket.CloseableSet;
import org.robotui.rtps.ParticipantSettings;
import org.robotui.rtps.internal.discovery.Ports;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The sockets of a participant: two at the ports of its number, one that hears the multicast group, and one for each
 * interface that sends to it.
 */
final class UdpSockets implements Closeable {

  private static final Logger LOG = LoggerFactory.getLogger(UdpSockets.class);
  private static final int RECEIVE_BUFFER = 8 << 20;
  private static final int SEND_BUFFER = 4 << 20;

  private final CloseableSet open = new CloseableSet();
  private final Addresses addresses;
  private final Ports ports;
  private final List<DatagramChannel> receiving = new ArrayList<>();
  private final List<DatagramChannel> groupSenders = new ArrayList<>();
  private DatagramChannel discovery;
  private int participant;

  private UdpSockets(ParticipantSettings settings, Addresses addresses) {
    this.addresses = addresses;
    this.ports = new Ports(settings.domain());
  }

  static UdpSockets open(ParticipantSettings settings, Addresses addresses) throws IOException {
    UdpSockets sockets = new UdpSockets(settings, addresses);
    try {
      sockets.unicast(settings);
      if (settings.multicast()) {
        sockets.group();
      }
      return sockets;
    } catch (IOException | RuntimeException e) {
      sockets.close();
      throw e;
    }
  }

  private void unicast(ParticipantSettings settings) throws IOException {
    int first = settings.participantId().orElse(0);
    int last = settings.participantId().orElse(ports.lastParticipantId());
    for (participant = first; participant <= last; participant++) {
      if (unicast(participant)) {
        return;
      }
    }
    throw new IOException(
        "the ports " + ports.metatrafficUnicast(first) + " to " + ports.userUnicast(last) + " of domain "
            + settings.domain() + " are all in use");
  }

  private boolean unicast(int number) throws IOException {
    DatagramChannel first = open();
    DatagramChannel second = open();
    try {
      first.bind(new InetSocketAddress(local(), ports.metatrafficUnicast(number)));
      second.bind(new InetSocketAddress(local(), ports.userUnicast(number)));
    } catch (BindException e) {
      LOG.debug("participant {} of domain {} is another one: {}", number, ports.domain(), e.getMessage());
      open.close(first);
      open.close(second);
      return false;
    }
    discovery = first;
    receiving.add(first);
    receiving.add(second);
    return true;
  }

  private InetAddress local() throws IOException {
    return addresses.used().size() == 1 ? addresses.used().getFirst().address()
        : InetAddress.getByAddress(new byte[4]);
  }

  private DatagramChannel open() throws IOException {
    DatagramChannel channel = DatagramChannel.open(StandardProtocolFamily.INET);
    open.add(channel);
    channel.configureBlocking(false);
    channel.setOption(StandardSocketOptions.SO_RCVBUF, RECEIVE_BUFFER);
    channel.setOption(StandardSocketOptions.SO_SNDBUF, SEND_BUFFER);
    return channel;
  }

  /** Bound to the group, so that nothing but what is sent to it is heard there. */
  private void group() throws IOException {
    DatagramChannel group = open();
    group.setOption(StandardSocketOptions.SO_REUSEADDR, true);
    group.bind(new InetSocketAddress(Ports.group(), ports.metatrafficMulticast()));
    List<String> faults = new ArrayList<>();
    for (Addresses.Used each : addresses.used()) {
      try {
        group.join(Ports.group(), each.networkInterface());
        DatagramChannel sender = open();
        sender.bind(new InetSocketAddress(each.address(), 0));
        sender.setOption(StandardSocketOptions.IP_MULTICAST_IF, each.networkInterface());
        groupSenders.add(sender);
      } catch (IOException | IllegalArgumentException e) {
        faults.add(each.networkInterface().getName() + ": " + e.getMessage());
      }
    }
    receiving.add(group);
    if (!faults.isEmpty()) {
      LOG.warn("multicast of domain {} does not work on all interfaces: {}", ports.domain(), faults);
    }
  }

  List<DatagramChannel> receiving() {
    return receiving;
  }

  List<DatagramChannel> groupSenders() {
    return groupSenders;
  }

  /** Sends to single addresses. */
  DatagramChannel sender() {
    return discovery;
  }

  int participant() {
    return participant;
  }

  @Override
  public void close() {
    open.close();
  }
}
