package org.robotui.ros;

import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.rosgraph_msgs.Log;
import org.robotui.message.ros.std_msgs.Header;

/**
 * A node's entries in the log of all nodes, {@code /rosout}. A node that opens none stays out of it. Any thread may
 * write; writing never waits.
 */
public final class RosLog implements AutoCloseable {

  /** How bad an entry is. */
  public enum Level {
    /** For developers. */
    DEBUG(Log.DEBUG),
    /** As it should be. */
    INFO(Log.INFO),
    /** Worth a look. */
    WARN(Log.WARN),
    /** Something does not work. */
    ERROR(Log.ERROR),
    /** Nothing works any more. */
    FATAL(Log.FATAL);

    private final int code;

    Level(int code) {
      this.code = code;
    }
  }

  private final RosNode node;
  private final Publisher<Log> rosout;
  private final AtomicLong sequence = new AtomicLong();

  private RosLog(RosNode node, Publisher<Log> rosout) {
    this.node = node;
    this.rosout = rosout;
  }

  /**
   * Publishes {@code /rosout}. The last entry is kept for whoever comes to listen, as ROS nodes do.
   *
   * @param node the node
   * @return the log
   * @throws IllegalStateException if the node publishes it already, or is closed
   */
  public static RosLog open(RosNode node) {
    return new RosLog(node, node.publisher("/rosout", RecordCodec.of(Log.class), PublisherOptions.latched()));
  }

  /**
   * Writes an entry, at the time of the node's clock.
   *
   * @param level how bad it is
   * @param where the part of the node it is about; stands where others name their source file
   * @param text for a user
   */
  public void write(Level level, String where, String text) {
    write(level, where, text, node.clock().nowNanos());
  }

  /**
   * Writes an entry.
   *
   * @param level how bad it is
   * @param where the part of the node it is about
   * @param text for a user
   * @param nanos when, nanoseconds since the epoch
   */
  public void write(Level level, String where, String text, long nanos) {
    Header header = new Header(sequence.incrementAndGet(), nanos, "");
    rosout.publish(new Log(header, level.code, node.name().text(), text, where, "", 0, List.of()));
  }

  @Override
  public void close() {
    rosout.close();
  }
}
