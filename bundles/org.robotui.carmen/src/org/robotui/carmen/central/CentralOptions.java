package org.robotui.carmen.central;

import java.net.InetAddress;
import java.util.concurrent.ThreadFactory;

/**
 * How a central is opened.
 *
 * @param threads makes its threads
 * @param address where it listens
 * @param port where it listens; 0 for a free one
 * @param direct whether modules shall send messages to each other without it
 */
public record CentralOptions(ThreadFactory threads, InetAddress address, int port, boolean direct) {

  /**
   * For this machine alone.
   *
   * @param threads makes its threads
   * @param port where it listens; 0 for a free one
   * @return messages go through it
   */
  public static CentralOptions loopback(ThreadFactory threads, int port) {
    return new CentralOptions(threads, InetAddress.getLoopbackAddress(), port, false);
  }
}
