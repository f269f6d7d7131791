package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A point ({@code geometry_msgs/Point}).
 *
 * @param x metres
 * @param y metres
 * @param z metres
 */
public record Point(double x, double y, double z) {

  /** Between records and bytes. */
  public static final RecordCodec<Point> CODEC =
      RecordCodec.of("geometry_msgs/Point", Point::read, Point::write);

  private static Point read(MessageReader in) throws MessageException {
    return new Point(in.float64("x"), in.float64("y"), in.float64("z"));
  }

  private static void write(Point m, MessageWriter out) {
    out.f64(m.x);
    out.f64(m.y);
    out.f64(m.z);
  }
}
