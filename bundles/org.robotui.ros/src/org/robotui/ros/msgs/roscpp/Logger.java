package org.robotui.ros.msgs.roscpp;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A logger of a node ({@code roscpp/Logger}).
 *
 * @param name  the logger
 * @param level its level, such as {@code info}
 */
public record Logger(String name, String level) {

  /** Between records and bytes. */
  public static final RecordCodec<Logger> CODEC =
      RecordCodec.of("roscpp/Logger", Logger::read, Logger::write);

  private static Logger read(MessageReader in) throws MessageException {
    return new Logger(in.string("name"), in.string("level"));
  }

  private static void write(Logger m, MessageWriter out) {
    out.string(m.name);
    out.string(m.level);
  }
}
