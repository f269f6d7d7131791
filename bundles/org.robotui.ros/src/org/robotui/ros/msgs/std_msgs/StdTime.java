package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.message.Stamps;

/**
 * A point in time ({@code std_msgs/Time}).
 *
 * @param data the value, nanoseconds since the epoch of the sender's clock
 */
public record StdTime(long data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdTime> CODEC =
      RecordCodec.of("std_msgs/Time", StdTime::read, StdTime::write);

  private static StdTime read(MessageReader in) throws MessageException {
    return new StdTime(in.time("data"));
  }

  private static void write(StdTime m, MessageWriter out) {
    Stamps.write(m.data, out);
  }
}
