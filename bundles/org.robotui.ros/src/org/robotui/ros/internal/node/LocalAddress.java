package org.robotui.ros.internal.node;

import java.io.IOException;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.util.Optional;

/**
 * Where a process listens and what it tells its peers. Without a configured host both are loopback; a configured
 * address that is this machine's own is listened on alone, any other name or address (as behind NAT) on all interfaces.
 */
public record LocalAddress(InetAddress bind, String announced) {

  public static LocalAddress of(Optional<String> host) throws IOException {
    InetAddress loopback = InetAddress.getByAddress(new byte[]{127, 0, 0, 1});
    if (host.isEmpty()) {
      return new LocalAddress(loopback, loopback.getHostAddress());
    }
    InetAddress address = InetAddress.getByName(host.get());
    if (address.isLoopbackAddress()) {
      return new LocalAddress(address, host.get());
    }
    boolean literal = host.get().equals(address.getHostAddress());
    boolean own = literal && NetworkInterface.getByInetAddress(address) != null;
    return new LocalAddress(own ? address : InetAddress.getByName("0.0.0.0"), host.get());
  }

  public String uri(String scheme, int port) {
    String host = announced.contains(":") ? "[" + announced + "]" : announced;
    return scheme + "://" + host + ":" + port;
  }
}
