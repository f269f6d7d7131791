package org.robotui.ros.msgs.roscpp;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Sets the level of a node's logger ({@code roscpp/SetLoggerLevelRequest}).
 *
 * @param logger the logger
 * @param level  the new level
 */
public record SetLoggerLevelRequest(String logger, String level) {

  /** Between records and bytes. */
  public static final RecordCodec<SetLoggerLevelRequest> CODEC =
      RecordCodec.of("roscpp/SetLoggerLevelRequest", SetLoggerLevelRequest::read, SetLoggerLevelRequest::write);

  private static SetLoggerLevelRequest read(MessageReader in) throws MessageException {
    return new SetLoggerLevelRequest(in.string("logger"), in.string("level"));
  }

  private static void write(SetLoggerLevelRequest m, MessageWriter out) {
    out.string(m.logger);
    out.string(m.level);
  }
}
