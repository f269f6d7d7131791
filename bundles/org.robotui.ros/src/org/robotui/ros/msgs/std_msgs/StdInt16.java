package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A signed integer ({@code std_msgs/Int16}).
 *
 * @param data the value, -32768 to 32767
 */
public record StdInt16(int data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdInt16> CODEC =
      RecordCodec.of("std_msgs/Int16", StdInt16::read, StdInt16::write);

  private static StdInt16 read(MessageReader in) throws MessageException {
    return new StdInt16(in.int16("data"));
  }

  private static void write(StdInt16 m, MessageWriter out) {
    out.i16(m.data);
  }
}
