package org.robotui.ros.master;

import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;

/**
 * What a master is given by its owner.
 *
 * @param threads makes all threads of the master
 * @param host the address or host name to announce; empty announces, and listens on, loopback only
 * @param port where to listen; 0 for a free port
 * @param rosout whether log messages of all nodes are gathered on /rosout_agg, as roscore does
 */
public record MasterOptions(ThreadFactory threads, Optional<String> host, int port, boolean rosout) {

  /** Checks that nothing is missing. */
  public MasterOptions {
    Objects.requireNonNull(threads, "threads");
    Objects.requireNonNull(host, "host");
    if (port < 0 || port > 65535) {
      throw new IllegalArgumentException("port " + port);
    }
  }

  /**
   * A master on a free loopback port, with rosout.
   *
   * @param threads makes all threads of the master
   * @return the default
   */
  public static MasterOptions standard(ThreadFactory threads) {
    return new MasterOptions(threads, Optional.empty(), 0, true);
  }

  /**
   * The same options with another port.
   *
   * @param newPort where to listen; 0 for a free port
   * @return the changed options
   */
  public MasterOptions withPort(int newPort) {
    return new MasterOptions(threads, host, newPort, rosout);
  }

  /**
   * The same options with another host to announce.
   *
   * @param newHost an address or a host name by which peers reach this machine
   * @return the changed options
   */
  public MasterOptions withHost(String newHost) {
    return new MasterOptions(threads, Optional.of(newHost), port, rosout);
  }
}
