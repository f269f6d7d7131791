package org.robotui.rtps.internal.transport;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InterfaceAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.rtps.Interfaces;

/**
 * The addresses of this machine that a participant uses.
 *
 * @param used interfaces with their addresses, those of loopback last
 * @param own all addresses of this machine
 * @param loopbackOnly whether nothing beyond this machine may be reached
 */
public record Addresses(List<Used> used, Set<InetAddress> own, boolean loopbackOnly) {

  /** An interface and one of its addresses. */
  public record Used(NetworkInterface networkInterface, Inet4Address address, int prefixLength) {

    boolean near(InetAddress other) {
      int mask = prefixLength == 0 ? 0 : -1 << Integer.SIZE - prefixLength;
      return other instanceof Inet4Address && (bits(address) & mask) == (bits(other) & mask);
    }

    private static int bits(InetAddress address) {
      return ByteBuffer.wrap(address.getAddress()).getInt();
    }
  }

  /** Finds those that are up. */
  public static Addresses of(Interfaces wanted) throws IOException {
    List<Used> all = all();
    List<Used> used = new ArrayList<>(all.stream().filter(each -> matches(wanted, each)).toList());
    used.sort((one, other) -> Boolean.compare(one.address().isLoopbackAddress(), other.address().isLoopbackAddress()));
    if (used.isEmpty()) {
      throw new IOException("no network interface with an address of IP version 4 fits " + wanted + "; there are "
          + all.stream().map(each -> each.networkInterface().getName() + " " + each.address().getHostAddress())
              .collect(Collectors.joining(", ")));
    }
    Set<InetAddress> own = new HashSet<>();
    all.forEach(each -> own.add(each.address()));
    return new Addresses(List.copyOf(used), Set.copyOf(own),
        used.stream().allMatch(each -> each.address().isLoopbackAddress()));
  }

  private static boolean matches(Interfaces wanted, Used each) {
    return switch (wanted) {
      case Interfaces.Loopback() -> each.address().isLoopbackAddress();
      case Interfaces.All() -> true;
      case Interfaces.Named(List<String> names) -> names.contains(each.networkInterface().getName())
          || names.contains(each.address().getHostAddress());
    };
  }

  private static List<Used> all() throws SocketException {
    List<Used> found = new ArrayList<>();
    for (NetworkInterface each : NetworkInterface.networkInterfaces().toList()) {
      if (each.isUp()) {
        for (InterfaceAddress address : each.getInterfaceAddresses()) {
          if (address.getAddress() instanceof Inet4Address four) {
            found.add(new Used(each, four, address.getNetworkPrefixLength()));
          }
        }
      }
    }
    return found;
  }

  /** Whether an address is one of this machine. */
  public boolean isOwn(InetAddress address) {
    return address.isLoopbackAddress() || own.contains(address);
  }

  /** Those that are announced: loopback only where there is nothing else. */
  public List<Inet4Address> announced() {
    List<Inet4Address> beyond =
        used.stream().map(Used::address).filter(each -> !each.isLoopbackAddress()).toList();
    return beyond.isEmpty() ? used.stream().map(Used::address).toList() : beyond;
  }
}
