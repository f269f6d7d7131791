package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * An acceleration ({@code geometry_msgs/Accel}).
 *
 * @param linear  metres per second squared
 * @param angular radians per second squared about x, y, z
 */
public record Accel(Vector3 linear, Vector3 angular) {

  /** Between records and bytes. */
  public static final RecordCodec<Accel> CODEC =
      RecordCodec.of("geometry_msgs/Accel", Accel::read, Accel::write);

  private static Accel read(MessageReader in) throws MessageException {
    return new Accel(in.nested("linear", Vector3.CODEC), in.nested("angular", Vector3.CODEC));
  }

  private static void write(Accel m, MessageWriter out) {
    Vector3.CODEC.encode(m.linear, out);
    Vector3.CODEC.encode(m.angular, out);
  }
}
