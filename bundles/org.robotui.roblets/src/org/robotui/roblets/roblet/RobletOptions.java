package org.robotui.roblets.roblet;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.ThreadFactory;
import org.robotui.net.socket.HostPort;
import org.robotui.roblets.wire.BodyDatagram;

/**
 * Where a roblet speaks, and how it is started again.
 *
 * @param threads makes its threads
 * @param brain where beacons go: the address of the brain, or one of a broadcast
 * @param own the address at which it listens; its port is a free one
 * @param restart the pause before it is started again; it doubles up to ten times as long while it fails
 */
public record RobletOptions(ThreadFactory threads, InetSocketAddress brain, InetAddress own, Duration restart) {
  /** The pause where nothing else is said. */
  public static final Duration USUAL_RESTART = Duration.ofMillis(500);

  /**
   * For a brain somewhere. A roblet of a brain on this machine listens on loopback alone.
   *
   * @param threads makes its threads
   * @param brain where it is
   * @return the options
   * @throws UnknownHostException where the name of the host is not known
   */
  public static RobletOptions of(ThreadFactory threads, HostPort brain) throws UnknownHostException {
    InetSocketAddress there = brain.resolve();
    return new RobletOptions(threads, there,
        there.getAddress().isLoopbackAddress() ? there.getAddress() : InetAddress.getByName("0.0.0.0"), USUAL_RESTART);
  }

  /**
   * For the brain that {@code ROBLETS_BRAIN} names, else for one on this machine.
   *
   * @param threads makes its threads
   * @param variables of the environment
   * @return the options
   * @throws UnknownHostException where the name of the host is not known
   */
  public static RobletOptions of(ThreadFactory threads, Map<String, String> variables) throws UnknownHostException {
    return of(threads, HostPort.ofVariable(BodyDatagram.BRAIN_VARIABLE,
        variables.getOrDefault(BodyDatagram.BRAIN_VARIABLE, ""), BodyDatagram.BRAIN_PORT));
  }
}
