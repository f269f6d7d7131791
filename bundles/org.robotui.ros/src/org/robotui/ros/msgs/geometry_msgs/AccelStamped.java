package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * An acceleration with time and frame ({@code geometry_msgs/AccelStamped}).
 *
 * @param header time and frame
 * @param accel  the acceleration
 */
public record AccelStamped(Header header, Accel accel) {

  /** Between records and bytes. */
  public static final RecordCodec<AccelStamped> CODEC =
      RecordCodec.of("geometry_msgs/AccelStamped", AccelStamped::read, AccelStamped::write);

  private static AccelStamped read(MessageReader in) throws MessageException {
    return new AccelStamped(in.nested("header", Header.CODEC), in.nested("accel", Accel.CODEC));
  }

  private static void write(AccelStamped m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Accel.CODEC.encode(m.accel, out);
  }
}
