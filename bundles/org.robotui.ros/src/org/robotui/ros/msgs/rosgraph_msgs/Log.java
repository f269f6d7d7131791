package org.robotui.ros.msgs.rosgraph_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A log entry of a node ({@code rosgraph_msgs/Log}).
 *
 * @param header   time
 * @param level    one of the constants, such as {@link #INFO}
 * @param name     the node
 * @param msg      the text
 * @param file     source file
 * @param function function in it
 * @param line     line in it
 * @param topics   topics the node publishes
 */
public record Log(
    Header header, int level, String name, String msg, String file, String function, long line, List<String>
    topics) {

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

  /** Between records and bytes. */
  public static final RecordCodec<Log> CODEC =
      RecordCodec.of("rosgraph_msgs/Log", Log::read, Log::write);

  /** Keeps immutable copies of lists. */
  public Log {
    topics = List.copyOf(topics);
  }

  private static Log read(MessageReader in) throws MessageException {
    return new Log(
        in.nested("header", Header.CODEC),
        in.int8("level"),
        in.string("name"),
        in.string("msg"),
        in.string("file"),
        in.string("function"),
        in.uint32("line"),
        in.strings("topics"));
  }

  private static void write(Log m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.u8(m.level);
    out.string(m.name);
    out.string(m.msg);
    out.string(m.file);
    out.string(m.function);
    out.i32((int) m.line);
    out.array(m.topics.size());
    m.topics.forEach(out::string);
  }
}
