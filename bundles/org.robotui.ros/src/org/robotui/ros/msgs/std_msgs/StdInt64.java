package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A signed integer ({@code std_msgs/Int64}).
 *
 * @param data the value
 */
public record StdInt64(long data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdInt64> CODEC =
      RecordCodec.of("std_msgs/Int64", StdInt64::read, StdInt64::write);

  private static StdInt64 read(MessageReader in) throws MessageException {
    return new StdInt64(in.int64("data"));
  }

  private static void write(StdInt64 m, MessageWriter out) {
    out.i64(m.data);
  }
}
