package org.robotui.message.ros.rosgraph_msgs;

import java.util.List;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * A log entry of a node ({@code rosgraph_msgs/Log}).
 *
 * @param header time
 * @param level one of the constants, such as {@link #INFO}
 * @param name the node
 * @param msg the text
 * @param file source file
 * @param function function in it
 * @param line line in it
 * @param topics topics the node publishes
 */
@MessageType("rosgraph_msgs/Log")
public record Log(
    Header header, int level, String name, String msg, String file, String function, long line, List<String> topics) {

  /** The constant {@code DEBUG} of the definition. */
  public static final int DEBUG = 1;
  /** The constant {@code INFO} of the definition. */
  public static final int INFO = 2;
  /** The constant {@code WARN} of the definition. */
  public static final int WARN = 4;
  /** The constant {@code ERROR} of the definition. */
  public static final int ERROR = 8;
  /** The constant {@code FATAL} of the definition. */
  public static final int FATAL = 16;

  /** Keeps immutable copies of lists. */
  public Log {
    topics = List.copyOf(topics);
  }
}
