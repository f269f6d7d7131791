package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A signed integer ({@code std_msgs/Int8}).
 *
 * @param data the value, -128 to 127
 */
public record StdInt8(int data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdInt8> CODEC =
      RecordCodec.of("std_msgs/Int8", StdInt8::read, StdInt8::write);

  private static StdInt8 read(MessageReader in) throws MessageException {
    return new StdInt8(in.int8("data"));
  }

  private static void write(StdInt8 m, MessageWriter out) {
    out.u8(m.data);
  }
}
