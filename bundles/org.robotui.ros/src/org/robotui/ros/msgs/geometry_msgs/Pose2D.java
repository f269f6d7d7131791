package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A pose in the plane ({@code geometry_msgs/Pose2D}).
 *
 * @param x     metres
 * @param y     metres
 * @param theta heading, radians
 */
public record Pose2D(double x, double y, double theta) {

  /** Between records and bytes. */
  public static final RecordCodec<Pose2D> CODEC =
      RecordCodec.of("geometry_msgs/Pose2D", Pose2D::read, Pose2D::write);

  private static Pose2D read(MessageReader in) throws MessageException {
    return new Pose2D(in.float64("x"), in.float64("y"), in.float64("theta"));
  }

  private static void write(Pose2D m, MessageWriter out) {
    out.f64(m.x);
    out.f64(m.y);
    out.f64(m.theta);
  }
}
