package org.robotui.rfic.lcm.internal;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.StandardSocketOptions;
import java.util.Map;
import org.robotui.testkit.rfic.Capability;

/**
 * A multicast group on loopback. It is always there: a robot that is away or hangs is silent, and that is all that can
 * be seen of it.
 */
final class UdpmBus implements LcmBus {
  private static final String GROUP = "239.255.76.69";

  private final int port;
  private volatile boolean holds;

  UdpmBus() throws IOException {
    try (DatagramSocket free = new DatagramSocket(0)) {
      port = free.getLocalPort();
    }
  }

  @Override
  public Map<Capability, String> lacks() {
    return Map.of(Capability.LINKS, "a group has no links: a robot that is away is one that says nothing");
  }

  @Override
  public String url() {
    return "udpm://" + GROUP + ":" + port + "?ttl=0&interface=lo";
  }

  @Override
  public String open() {
    return url();
  }

  @Override
  public void shut() {
    holds = false;
  }

  @Override
  public void hold() {
    holds = true;
  }

  @Override
  public void goOn() {
    holds = false;
  }

  @Override
  public boolean holds() {
    return holds;
  }

  @Override
  public void inject(byte[] bytes) throws IOException {
    try (MulticastSocket socket = new MulticastSocket()) {
      socket.setOption(StandardSocketOptions.IP_MULTICAST_IF, NetworkInterface.getByName("lo"));
      socket.setTimeToLive(0);
      socket.send(new DatagramPacket(bytes, bytes.length, InetAddress.getByName(GROUP), port));
    }
  }

  @Override
  public int links() {
    return 0;
  }

  @Override
  public void close() {
    shut();
  }
}
