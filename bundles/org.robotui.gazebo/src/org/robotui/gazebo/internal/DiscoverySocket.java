package org.robotui.gazebo.internal;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.net.StandardSocketOptions;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The multicast socket of discovery. At a loopback address it sends to this machine alone, and takes only what this
 * machine sends, by whatever interface it does that: a simulator that was not told otherwise uses those to others.
 */
final class DiscoverySocket implements AutoCloseable {
  private static final int LOOK_MILLIS = 100;
  private static final int MOST = 1 << Short.SIZE;

  private final DatagramSocket socket;
  private final InetSocketAddress group;
  private final boolean thisMachine;
  private final byte[] buffer = new byte[MOST];
  private final Set<InetAddress> own = ConcurrentHashMap.newKeySet();

  /** A datagram that came. Its bytes are there until the next one is waited for. */
  record Datagram(byte[] bytes, int size, InetAddress from, boolean local) {}

  DiscoverySocket(InetAddress address, InetAddress group, int port) throws IOException {
    this.group = new InetSocketAddress(group, port);
    this.thisMachine = address.isLoopbackAddress();
    NetworkInterface out = Optional.ofNullable(NetworkInterface.getByInetAddress(address)).orElseThrow(
        () -> new IOException(address.getHostAddress() + " is no address of this machine"));
    this.socket = new DatagramSocket(null);
    try {
      socket.setReuseAddress(true);
      socket.bind(new InetSocketAddress(port));
      socket.setSoTimeout(LOOK_MILLIS);
      socket.setOption(StandardSocketOptions.IP_MULTICAST_IF, out);
      socket.setOption(StandardSocketOptions.IP_MULTICAST_LOOP, true);
      join(out);
    } catch (IOException | RuntimeException e) {
      socket.close();
      throw new IOException("discovery at " + group.getHostAddress() + ":" + port + ": " + e.getMessage(), e);
    }
  }

  private void join(NetworkInterface out) throws IOException {
    socket.joinGroup(group, out);
    for (NetworkInterface each : thisMachine ? NetworkInterface.networkInterfaces().toList()
        : List.<NetworkInterface>of()) {
      if (!each.equals(out) && each.isUp() && each.supportsMulticast()
          && each.inetAddresses().anyMatch(java.net.Inet4Address.class::isInstance)) {
        joinIfPossible(each);
      }
    }
  }

  /** What an interface refuses that was not asked for by name is no fault. */
  private void joinIfPossible(NetworkInterface each) {
    try {
      socket.joinGroup(group, each);
    } catch (IOException e) {
      // nothing is heard of a simulator that sends by this interface alone
    }
  }

  /** Waits a moment for a datagram that concerns this node. */
  Optional<Datagram> receive() throws IOException {
    DatagramPacket packet = new DatagramPacket(buffer, buffer.length);
    try {
      socket.receive(packet);
    } catch (SocketTimeoutException e) {
      return Optional.empty();
    }
    boolean local = isOwn(packet.getAddress());
    return local || !thisMachine
        ? Optional.of(new Datagram(buffer, packet.getLength(), packet.getAddress(), local))
        : Optional.empty();
  }

  private boolean isOwn(InetAddress from) throws SocketException {
    if (from.isLoopbackAddress() || own.contains(from)) {
      return true;
    }
    boolean known = NetworkInterface.getByInetAddress(from) != null;
    if (known) {
      own.add(from);
    }
    return known;
  }

  void send(byte[] datagram) throws IOException {
    socket.send(new DatagramPacket(datagram, datagram.length, group));
  }

  boolean isClosed() {
    return socket.isClosed();
  }

  @Override
  public void close() {
    socket.close();
  }
}
