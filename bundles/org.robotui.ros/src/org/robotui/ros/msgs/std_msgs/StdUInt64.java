package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * An unsigned integer ({@code std_msgs/UInt64}).
 *
 * @param data the bits of the value
 */
public record StdUInt64(long data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdUInt64> CODEC =
      RecordCodec.of("std_msgs/UInt64", StdUInt64::read, StdUInt64::write);

  private static StdUInt64 read(MessageReader in) throws MessageException {
    return new StdUInt64(in.int64("data"));
  }

  private static void write(StdUInt64 m, MessageWriter out) {
    out.i64(m.data);
  }
}
