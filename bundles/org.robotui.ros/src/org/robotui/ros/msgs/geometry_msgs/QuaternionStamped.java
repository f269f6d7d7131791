package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * An orientation with time and frame ({@code geometry_msgs/QuaternionStamped}).
 *
 * @param header     time and frame
 * @param quaternion the orientation
 */
public record QuaternionStamped(Header header, Quaternion quaternion) {

  /** Between records and bytes. */
  public static final RecordCodec<QuaternionStamped> CODEC =
      RecordCodec.of("geometry_msgs/QuaternionStamped", QuaternionStamped::read, QuaternionStamped::write);

  private static QuaternionStamped read(MessageReader in) throws MessageException {
    return new QuaternionStamped(in.nested("header", Header.CODEC), in.nested("quaternion", Quaternion.CODEC));
  }

  private static void write(QuaternionStamped m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Quaternion.CODEC.encode(m.quaternion, out);
  }
}
