package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A rotation, of unit length where the sender keeps the rules ({@code geometry_msgs/Quaternion}).
 *
 * @param x imaginary part along x
 * @param y imaginary part along y
 * @param z imaginary part along z
 * @param w real part
 */
public record Quaternion(double x, double y, double z, double w) {

  /** Between records and bytes. */
  public static final RecordCodec<Quaternion> CODEC =
      RecordCodec.of("geometry_msgs/Quaternion", Quaternion::read, Quaternion::write);

  private static Quaternion read(MessageReader in) throws MessageException {
    return new Quaternion(in.float64("x"), in.float64("y"), in.float64("z"), in.float64("w"));
  }

  private static void write(Quaternion m, MessageWriter out) {
    out.f64(m.x);
    out.f64(m.y);
    out.f64(m.z);
    out.f64(m.w);
  }
}
