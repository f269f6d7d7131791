package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A text ({@code std_msgs/String}).
 *
 * @param data the text
 */
public record StdString(String data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdString> CODEC =
      RecordCodec.of("std_msgs/String", StdString::read, StdString::write);

  private static StdString read(MessageReader in) throws MessageException {
    return new StdString(in.string("data"));
  }

  private static void write(StdString m, MessageWriter out) {
    out.string(m.data);
  }
}
