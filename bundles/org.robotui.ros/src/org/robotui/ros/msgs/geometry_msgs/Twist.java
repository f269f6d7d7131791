package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A velocity ({@code geometry_msgs/Twist}).
 *
 * @param linear  metres per second
 * @param angular radians per second about x, y, z
 */
public record Twist(Vector3 linear, Vector3 angular) {

  /** Between records and bytes. */
  public static final RecordCodec<Twist> CODEC =
      RecordCodec.of("geometry_msgs/Twist", Twist::read, Twist::write);

  private static Twist read(MessageReader in) throws MessageException {
    return new Twist(in.nested("linear", Vector3.CODEC), in.nested("angular", Vector3.CODEC));
  }

  private static void write(Twist m, MessageWriter out) {
    Vector3.CODEC.encode(m.linear, out);
    Vector3.CODEC.encode(m.angular, out);
  }
}
