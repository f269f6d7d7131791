package org.robotui.smartsoft.server;

import java.net.InetAddress;
import java.util.concurrent.ThreadFactory;

/**
 * Where a service listens.
 *
 * @param threads makes its threads
 * @param address of which network interface
 * @param port 0 for a free one
 */
public record SmartServerOptions(ThreadFactory threads, InetAddress address, int port) {

  /**
   * Reached from this machine alone, on a free port.
   *
   * @param threads makes the threads
   * @return on loopback
   */
  public static SmartServerOptions loopback(ThreadFactory threads) {
    return new SmartServerOptions(threads, InetAddress.getLoopbackAddress(), 0);
  }
}
