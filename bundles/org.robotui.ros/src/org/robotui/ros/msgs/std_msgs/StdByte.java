package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A signed byte ({@code std_msgs/Byte}).
 *
 * @param data the value, -128 to 127
 */
public record StdByte(int data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdByte> CODEC =
      RecordCodec.of("std_msgs/Byte", StdByte::read, StdByte::write);

  private static StdByte read(MessageReader in) throws MessageException {
    return new StdByte(in.int8("data"));
  }

  private static void write(StdByte m, MessageWriter out) {
    out.u8(m.data);
  }
}
