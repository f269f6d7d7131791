package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * An unsigned integer ({@code std_msgs/UInt16}).
 *
 * @param data the value, 0 to 65535
 */
public record StdUInt16(int data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdUInt16> CODEC =
      RecordCodec.of("std_msgs/UInt16", StdUInt16::read, StdUInt16::write);

  private static StdUInt16 read(MessageReader in) throws MessageException {
    return new StdUInt16(in.uint16("data"));
  }

  private static void write(StdUInt16 m, MessageWriter out) {
    out.i16(m.data);
  }
}
