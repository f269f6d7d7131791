package org.robotui.lcm.tcpq;

import java.net.InetAddress;
import java.time.Duration;
import java.util.Objects;
import java.util.concurrent.ThreadFactory;

/**
 * What a server of messages is given by its owner.
 *
 * @param threads makes all its threads
 * @param address where it listens
 * @param port on which port; 0: any that is free
 * @param maxMessageBytes the longest message that is accepted
 * @param queueBytes how much waits for one slow client at most; then the oldest messages for it are dropped
 * @param maxClients how many clients at most
 * @param greetingTime how long a client may take to greet
 */
public record TcpqServerOptions(ThreadFactory threads, InetAddress address, int port, int maxMessageBytes,
    long queueBytes, int maxClients,
    Duration greetingTime) {

  /** Checks the bounds. */
  public TcpqServerOptions {
    Objects.requireNonNull(threads, "threads");
    Objects.requireNonNull(address, "address");
    if (maxMessageBytes < 1 || maxMessageBytes > Integer.MAX_VALUE - 8 || queueBytes < 1 || maxClients < 1) {
      throw new IllegalArgumentException(
          "messages of " + maxMessageBytes + " and queues of " + queueBytes + " bytes, " + maxClients + " clients");
    }
  }

  /**
   * On loopback: messages up to 64 MiB, as much for each of at most 64 clients, which greet within 5 s.
   *
   * @param threads makes all threads of the server
   * @param port on which port; 0: any that is free
   * @return the default
   */
  public static TcpqServerOptions loopback(ThreadFactory threads, int port) {
    return new TcpqServerOptions(threads, InetAddress.getLoopbackAddress(), port, 64 << 20, 64L << 20, 64,
        Duration.ofSeconds(5));
  }

  /**
   * The same options with other bounds.
   *
   * @param messageBytes the longest message that is accepted
   * @param waiting how much waits for one slow client at most
   * @param clients how many clients at most
   * @return the changed options
   */
  public TcpqServerOptions withBounds(int messageBytes, long waiting, int clients) {
    return new TcpqServerOptions(threads, address, port, messageBytes, waiting, clients, greetingTime);
  }

  /**
   * The same options with another patience.
   *
   * @param greeting how long a client may take to greet
   * @return the changed options
   */
  public TcpqServerOptions withGreetingTime(Duration greeting) {
    return new TcpqServerOptions(threads, address, port, maxMessageBytes, queueBytes, maxClients, greeting);
  }
}
