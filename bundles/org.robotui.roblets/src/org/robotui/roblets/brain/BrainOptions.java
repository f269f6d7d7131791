package org.robotui.roblets.brain;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.concurrent.ThreadFactory;
import org.robotui.roblets.wire.BodyDatagram;

/**
 * How a brain is reached, and what it remembers.
 *
 * @param threads makes its threads
 * @param own where it listens; a port of 0 is a free one
 * @param robot the name of the robot
 * @param history how many messages of each name are remembered
 */
public record BrainOptions(ThreadFactory threads, InetSocketAddress own, String robot, int history) {
  private static final int HISTORY = 100;

  /**
   * A brain whose roblets are on this machine.
   *
   * @param threads makes its threads
   * @param port where it listens; 0 for a free one, {@value BodyDatagram#BRAIN_PORT} usually
   * @param robot the name of the robot
   * @return the options
   */
  public static BrainOptions loopback(ThreadFactory threads, int port, String robot) {
    return new BrainOptions(threads, new InetSocketAddress(InetAddress.getLoopbackAddress(), port), robot, HISTORY);
  }
}
