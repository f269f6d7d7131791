package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * An unsigned byte ({@code std_msgs/Char}).
 *
 * @param data the value, 0 to 255
 */
public record StdChar(int data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdChar> CODEC =
      RecordCodec.of("std_msgs/Char", StdChar::read, StdChar::write);

  private static StdChar read(MessageReader in) throws MessageException {
    return new StdChar(in.uint8("data"));
  }

  private static void write(StdChar m, MessageWriter out) {
    out.u8(m.data);
  }
}
