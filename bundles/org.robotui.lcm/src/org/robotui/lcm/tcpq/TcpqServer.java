package org.robotui.lcm.tcpq;

import java.io.IOException;
import java.net.InetSocketAddress;
import org.robotui.lcm.internal.tcpq.ServerRuntime;

/**
 * A server of messages: what one client publishes reaches all that subscribed to its channel, the publisher included.
 * The clients of all LCM implementations may use it by {@code tcpq://HOST:PORT}. Any thread may use it.
 */
public interface TcpqServer extends AutoCloseable {

  /**
   * Opens a server.
   *
   * @param options what the owner gives it
   * @return the open server
   * @throws IOException if it cannot listen; the message names the address
   */
  static TcpqServer open(TcpqServerOptions options) throws IOException {
    return ServerRuntime.open(options);
  }

  /**
   * Where it listens.
   *
   * @return address and port
   */
  InetSocketAddress address();

  /**
   * How many clients are connected.
   *
   * @return those that greeted
   */
  int clients();

  /**
   * How many messages slow clients did not get.
   *
   * @return the number of messages
   */
  long dropped();

  /**
   * How many clients were refused or sent away because of what they said.
   *
   * @return the number of connections
   */
  long refused();

  /** Closes all connections in less than a second. */
  @Override
  void close();
}
