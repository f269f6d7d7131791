package org.robotui.smartsoft.wire;

import java.time.Duration;
import java.util.concurrent.ThreadFactory;
import javax.net.SocketFactory;

/**
 * How services are linked to.
 *
 * @param threads makes their threads
 * @param sockets makes their connections
 * @param patience how long connecting may take, and a server until it takes the connection
 */
public record LinkOptions(ThreadFactory threads, SocketFactory sockets, Duration patience) {

  private static final Duration PATIENCE = Duration.ofSeconds(3);

  /**
   * The usual ones.
   *
   * @param threads makes the threads
   * @return with sockets of the platform
   */
  public static LinkOptions of(ThreadFactory threads) {
    return new LinkOptions(threads, SocketFactory.getDefault(), PATIENCE);
  }
}
