package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A signed integer ({@code std_msgs/Int32}).
 *
 * @param data the value
 */
public record StdInt32(int data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdInt32> CODEC =
      RecordCodec.of("std_msgs/Int32", StdInt32::read, StdInt32::write);

  private static StdInt32 read(MessageReader in) throws MessageException {
    return new StdInt32(in.int32("data"));
  }

  private static void write(StdInt32 m, MessageWriter out) {
    out.i32(m.data);
  }
}
