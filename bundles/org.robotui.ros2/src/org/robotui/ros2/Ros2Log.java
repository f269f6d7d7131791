package org.robotui.ros2;

import org.robotui.message.ros.rcl_interfaces.RclLog;

/**
 * A node's entries in the log of all nodes, {@code /rosout}. A node that opens none stays out of it. Any thread may
 * write; writing never waits.
 */
public final class Ros2Log implements AutoCloseable {

  private final Ros2Node node;
  private final Ros2Publisher<RclLog> rosout;

  private Ros2Log(Ros2Node node, Ros2Publisher<RclLog> rosout) {
    this.node = node;
    this.rosout = rosout;
  }

  /**
   * Publishes {@code /rosout}. Entries of the last ten seconds are kept for whoever comes to listen.
   *
   * @param node the node
   * @return the log
   * @throws IllegalStateException if the node is closed
   */
  public static Ros2Log open(Ros2Node node) {
    return new Ros2Log(node, node.publisher("/rosout", Ros2Codec.of(RclLog.class), QosProfiles.LOG));
  }

  /**
   * Writes an entry.
   *
   * @param level how bad it is
   * @param where the part of the node it is about; stands where others name their function
   * @param text for a user
   * @param nanos when, nanoseconds since the epoch of the node's clock
   */
  public void write(Ros2LogLevel level, String where, String text, long nanos) {
    String logger = node.name().text().substring(1).replace('/', '.');
    rosout.publish(new RclLog(nanos, level.code(), logger, text, "", where, 0));
  }

  @Override
  public void close() {
    rosout.close();
  }
}
