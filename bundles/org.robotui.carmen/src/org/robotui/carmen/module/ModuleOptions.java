package org.robotui.carmen.module;

import java.time.Duration;
import java.util.concurrent.ThreadFactory;
import javax.net.SocketFactory;

/**
 * How a module is linked.
 *
 * @param name what it is called; a number is put behind it
 * @param threads makes its threads
 * @param sockets makes its connections
 * @param patience how long a central, or another module, may take for an answer
 */
public record ModuleOptions(String name, ThreadFactory threads, SocketFactory sockets, Duration patience) {

  private static final Duration PATIENCE = Duration.ofSeconds(3);

  /**
   * The usual ones.
   *
   * @param name what it is called
   * @param threads makes its threads
   * @return with sockets of the platform
   */
  public static ModuleOptions of(String name, ThreadFactory threads) {
    return new ModuleOptions(name, threads, SocketFactory.getDefault(), PATIENCE);
  }
}
