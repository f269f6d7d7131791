package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * An unsigned integer ({@code std_msgs/UInt32}).
 *
 * @param data the value, 0 to 4294967295
 */
public record StdUInt32(long data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdUInt32> CODEC =
      RecordCodec.of("std_msgs/UInt32", StdUInt32::read, StdUInt32::write);

  private static StdUInt32 read(MessageReader in) throws MessageException {
    return new StdUInt32(in.uint32("data"));
  }

  private static void write(StdUInt32 m, MessageWriter out) {
    out.i32((int) m.data);
  }
}
