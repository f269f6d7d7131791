package org.robotui.yarp.port;

import java.time.Duration;
import java.util.concurrent.ThreadFactory;
import javax.net.SocketFactory;

/**
 * What ports and connections need.
 *
 * @param threads makes their threads
 * @param sockets makes their connections
 * @param patience how long others may take to accept a connection, and to answer
 */
public record PortOptions(ThreadFactory threads, SocketFactory sockets, Duration patience) {
  private static final Duration PATIENCE = Duration.ofSeconds(3);

  /**
   * The usual ones.
   *
   * @param threads makes their threads
   * @return with sockets of the platform
   */
  public static PortOptions of(ThreadFactory threads) {
    return new PortOptions(threads, SocketFactory.getDefault(), PATIENCE);
  }
}
