package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A velocity with time and frame ({@code geometry_msgs/TwistStamped}).
 *
 * @param header time and frame
 * @param twist  the velocity
 */
public record TwistStamped(Header header, Twist twist) {

  /** Between records and bytes. */
  public static final RecordCodec<TwistStamped> CODEC =
      RecordCodec.of("geometry_msgs/TwistStamped", TwistStamped::read, TwistStamped::write);

  private static TwistStamped read(MessageReader in) throws MessageException {
    return new TwistStamped(in.nested("header", Header.CODEC), in.nested("twist", Twist.CODEC));
  }

  private static void write(TwistStamped m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Twist.CODEC.encode(m.twist, out);
  }
}
