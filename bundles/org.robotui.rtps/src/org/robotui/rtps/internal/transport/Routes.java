package org.robotui.rtps.internal.transport;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import org.robotui.rtps.Locator;

/** Chooses among the addresses that a participant announces the one that it is reached by. */
public final class Routes {

  /** Over loopback a fragment is as long as a datagram can be; else it fits into an Ethernet frame. */
  private static final int LOOPBACK_DATAGRAM = 65_000;
  private static final int NETWORK_DATAGRAM = 1_468;

  private final Addresses addresses;

  /** From the addresses of this machine. */
  public Routes(Addresses addresses) {
    this.addresses = addresses;
  }

  /** The best address, if there is one that we may use; it was heard from a certain one. */
  public Optional<InetSocketAddress> choose(List<Locator> announced, InetAddress heardFrom) {
    List<InetSocketAddress> usable = announced.stream().flatMap(each -> each.socketAddress().stream())
        .filter(each -> usable(each.getAddress(), heardFrom)).toList();
    Optional<InetSocketAddress> same =
        usable.stream().filter(each -> each.getAddress().equals(heardFrom)).findFirst();
    Optional<InetSocketAddress> near = usable.stream().filter(each -> near(each.getAddress())).findFirst();
    return same.or(() -> near).or(() -> usable.stream().findFirst());
  }

  private boolean usable(InetAddress address, InetAddress heardFrom) {
    if (address.isAnyLocalAddress() || address.isMulticastAddress()) {
      return false;
    }
    if (address.isLoopbackAddress()) {
      return addresses.isOwn(heardFrom);
    }
    return !addresses.loopbackOnly() || addresses.isOwn(address);
  }

  private boolean near(InetAddress address) {
    return addresses.isOwn(address) || addresses.used().stream().anyMatch(each -> each.near(address));
  }

  /** The longest datagram that is sent to an address. */
  public int mostDatagram(InetAddress address) {
    return addresses.isOwn(address) ? LOOPBACK_DATAGRAM : NETWORK_DATAGRAM;
  }
}
