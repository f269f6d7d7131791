package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A truth value ({@code std_msgs/Bool}).
 *
 * @param data the value
 */
public record StdBool(boolean data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdBool> CODEC =
      RecordCodec.of("std_msgs/Bool", StdBool::read, StdBool::write);

  private static StdBool read(MessageReader in) throws MessageException {
    return new StdBool(in.bool("data"));
  }

  private static void write(StdBool m, MessageWriter out) {
    out.bool(m.data);
  }
}
