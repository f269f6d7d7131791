package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A point in single precision ({@code geometry_msgs/Point32}).
 *
 * @param x metres
 * @param y metres
 * @param z metres
 */
public record Point32(float x, float y, float z) {

  /** Between records and bytes. */
  public static final RecordCodec<Point32> CODEC =
      RecordCodec.of("geometry_msgs/Point32", Point32::read, Point32::write);

  private static Point32 read(MessageReader in) throws MessageException {
    return new Point32(in.float32("x"), in.float32("y"), in.float32("z"));
  }

  private static void write(Point32 m, MessageWriter out) {
    out.f32(m.x);
    out.f32(m.y);
    out.f32(m.z);
  }
}
