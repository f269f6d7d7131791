package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.message.Stamps;

/**
 * A span of time ({@code std_msgs/Duration}).
 *
 * @param data the value, nanoseconds
 */
public record StdDuration(long data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdDuration> CODEC =
      RecordCodec.of("std_msgs/Duration", StdDuration::read, StdDuration::write);

  private static StdDuration read(MessageReader in) throws MessageException {
    return new StdDuration(in.duration("data"));
  }

  private static void write(StdDuration m, MessageWriter out) {
    Stamps.write(m.data, out);
  }
}
