package org.robotui.lcm.internal.udpm;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.util.Optional;
import java.util.stream.Collectors;

/** Chooses the network interface for a multicast group: the one that is named, else the one of the system's route. */
final class Interfaces {

  private static final String ADVICE =
      "; see that the interface is up and knows multicast, as in: ip link set lo multicast on;"
          + " ip route add 224.0.0.0/4 dev lo";

  private Interfaces() {}

  /** An interface, and what to do when it does not work. */
  record Choice(NetworkInterface networkInterface, String advice) {}

  static Choice choose(InetSocketAddress group, Optional<String> name, int ttl) throws IOException {
    if (name.isPresent()) {
      return new Choice(named(name.get()), ADVICE);
    }
    Optional<NetworkInterface> routed = routed(group);
    if (routed.isPresent()) {
      return new Choice(routed.get(), ADVICE);
    }
    if (ttl > 0) {
      throw new IOException("there is no route to " + group.getAddress().getHostAddress()
          + "; name an interface in the URL, as in interface=eth0, or add a route, as in: ip route add 224.0.0.0/4 dev eth0");
    }
    return new Choice(loopback(), ADVICE);
  }

  private static NetworkInterface named(String name) throws IOException {
    NetworkInterface found = NetworkInterface.getByName(name);
    if (found == null) {
      throw new IOException("there is no network interface '" + name + "', but "
          + NetworkInterface.networkInterfaces().map(NetworkInterface::getName).collect(Collectors.joining(", ")));
    }
    return found;
  }

  /** Connecting a datagram socket sends nothing, but says from which address would be sent. */
  private static Optional<NetworkInterface> routed(InetSocketAddress group) throws SocketException {
    try (DatagramSocket probe = new DatagramSocket()) {
      probe.connect(group);
      return Optional.ofNullable(NetworkInterface.getByInetAddress(probe.getLocalAddress()));
    } catch (SocketException | UncheckedIOException e) {
      return Optional.empty();
    }
  }

  private static NetworkInterface loopback() throws IOException {
    return NetworkInterface.networkInterfaces().filter(Interfaces::isLoopback).findFirst()
        .orElseThrow(() -> new IOException("this machine has no network interface that is up" + ADVICE));
  }

  private static boolean isLoopback(NetworkInterface candidate) {
    try {
      return candidate.isLoopback() && candidate.isUp();
    } catch (SocketException e) {
      return false;
    }
  }
}
