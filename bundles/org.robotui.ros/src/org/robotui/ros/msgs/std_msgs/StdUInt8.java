package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * An unsigned integer ({@code std_msgs/UInt8}).
 *
 * @param data the value, 0 to 255
 */
public record StdUInt8(int data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdUInt8> CODEC =
      RecordCodec.of("std_msgs/UInt8", StdUInt8::read, StdUInt8::write);

  private static StdUInt8 read(MessageReader in) throws MessageException {
    return new StdUInt8(in.uint8("data"));
  }

  private static void write(StdUInt8 m, MessageWriter out) {
    out.u8(m.data);
  }
}
