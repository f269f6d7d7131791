package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A vector ({@code geometry_msgs/Vector3}).
 *
 * @param x along x
 * @param y along y
 * @param z along z
 */
public record Vector3(double x, double y, double z) {

  /** Between records and bytes. */
  public static final RecordCodec<Vector3> CODEC =
      RecordCodec.of("geometry_msgs/Vector3", Vector3::read, Vector3::write);

  private static Vector3 read(MessageReader in) throws MessageException {
    return new Vector3(in.float64("x"), in.float64("y"), in.float64("z"));
  }

  private static void write(Vector3 m, MessageWriter out) {
    out.f64(m.x);
    out.f64(m.y);
    out.f64(m.z);
  }
}
