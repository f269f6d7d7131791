package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A number ({@code std_msgs/Float64}).
 *
 * @param data the value
 */
public record StdFloat64(double data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdFloat64> CODEC =
      RecordCodec.of("std_msgs/Float64", StdFloat64::read, StdFloat64::write);

  private static StdFloat64 read(MessageReader in) throws MessageException {
    return new StdFloat64(in.float64("data"));
  }

  private static void write(StdFloat64 m, MessageWriter out) {
    out.f64(m.data);
  }
}
