package org.robotui.rtps;

import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.util.Optional;

/**
 * Where an entity can be reached.
 *
 * @param kind how, such as {@link #UDP_V4}; others are kept, but cannot be reached by this library
 * @param port the port, as the kind has it
 * @param high the first eight bytes of the address
 * @param low the last eight bytes; those of IP version 4 are the last four of these
 */
public record Locator(int kind, int port, long high, long low) {

  /** UDP over IP version 4. */
  public static final int UDP_V4 = 1;

  /** UDP over IP version 6. */
  public static final int UDP_V6 = 2;

  private static final long LAST_FOUR = 0xffff_ffffL;

  /**
   * A place that UDP reaches.
   *
   * @param address an address of IP version 4
   * @param port the port
   * @return the locator
   * @throws IllegalArgumentException if the address is none of version 4
   */
  public static Locator udp(InetAddress address, int port) {
    if (!(address instanceof Inet4Address)) {
      throw new IllegalArgumentException(address.getHostAddress() + " is no address of IP version 4");
    }
    return new Locator(UDP_V4, port, 0, ByteBuffer.wrap(address.getAddress()).getInt() & LAST_FOUR);
  }

  /**
   * Where datagrams go.
   *
   * @return the address, if it can be reached by UDP over IP version 4
   */
  public Optional<InetSocketAddress> socketAddress() {
    if (kind != UDP_V4 || port < 1 || port > 0xffff) {
      return Optional.empty();
    }
    return Optional.of(new InetSocketAddress(ip(), port));
  }

  private InetAddress ip() {
    try {
      return InetAddress.getByAddress(ByteBuffer.allocate(4).putInt((int) low).array());
    } catch (UnknownHostException e) {
      throw new IllegalStateException("four bytes are an address", e);
    }
  }

  /** As a person reads it. */
  @Override
  public String toString() {
    return socketAddress().map(address -> address.getAddress().getHostAddress() + ":" + port)
        .orElseGet(() -> "kind %d, %016x%016x:%d".formatted(kind, high, low, port));
  }
}
