package org.robotui.roboframe.board;

import java.net.InetAddress;
import java.net.UnknownHostException;
import org.robotui.net.socket.HostPort;
import org.robotui.roboframe.wire.BrokerFraming;

/** How an application comes to others: it waits for them, or it goes there. */
public sealed interface Connector {

  /**
   * Waits for others.
   *
   * @param address on which network interface
   * @param port 0 for any that is free
   */
  record Listen(InetAddress address, int port) implements Connector {}

  /**
   * Goes to another one, again and again until it is there.
   *
   * @param address where it listens
   */
  record Connect(HostPort address) implements Connector {}

  /**
   * Reads one as it is configured.
   *
   * @param written {@code listen:7420}, which is on loopback, {@code listen:ADDRESS:7420}, or {@code connect:HOST:7420}
   * @return the connector
   * @throws IllegalArgumentException where it is none; says what to write
   */
  static Connector parse(String written) {
    int colon = written.indexOf(':');
    String rest = colon < 0 ? "" : written.substring(colon + 1).strip();
    try {
      return switch (colon < 0 ? "" : written.substring(0, colon).strip()) {
        case "listen" -> listen(rest);
        case "connect" -> new Connect(HostPort.ofVariable("connect", rest, BrokerFraming.PORT));
        default -> throw new IllegalArgumentException(written);
      };
    } catch (IllegalArgumentException | UnknownHostException e) {
      throw new IllegalArgumentException("'" + written
          + "' is no connector; write listen:7420, listen:0.0.0.0:7420 or connect:HOST:7420", e);
    }
  }

  private static Connector listen(String rest) throws UnknownHostException {
    int colon = rest.lastIndexOf(':');
    int port = Integer.parseInt(rest.substring(colon + 1));
    if (port < 0 || port > 0xffff) {
      throw new IllegalArgumentException(rest);
    }
    return new Listen(colon < 0 ? InetAddress.getLoopbackAddress() : InetAddress.getByName(rest.substring(0, colon)),
        port);
  }
}
