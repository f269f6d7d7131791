package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.message.Stamps;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A time from another clock ({@code sensor_msgs/TimeReference}).
 *
 * @param header  time on the sender's clock
 * @param timeRef time on the other clock, nanoseconds since the epoch of the sender's clock
 * @param source  the other clock's name
 */
public record TimeReference(Header header, long timeRef, String source) {

  /** Between records and bytes. */
  public static final RecordCodec<TimeReference> CODEC =
      RecordCodec.of("sensor_msgs/TimeReference", TimeReference::read, TimeReference::write);

  private static TimeReference read(MessageReader in) throws MessageException {
    return new TimeReference(in.nested("header", Header.CODEC), in.time("time_ref"), in.string("source"));
  }

  private static void write(TimeReference m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Stamps.write(m.timeRef, out);
    out.string(m.source);
  }
}
