package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A velocity and how sure it is ({@code geometry_msgs/TwistWithCovariance}).
 *
 * @param twist      the velocity
 * @param covariance 6 x 6, row by row: x, y, z, rotations about x, y, z
 */
public record TwistWithCovariance(Twist twist, double[] covariance) {

  /** Between records and bytes. */
  public static final RecordCodec<TwistWithCovariance> CODEC =
      RecordCodec.of("geometry_msgs/TwistWithCovariance", TwistWithCovariance::read, TwistWithCovariance::write);

  /** Checks the lengths of fixed arrays. */
  public TwistWithCovariance {
    RecordCodec.requireLength("covariance", covariance.length, 36);
  }

  private static TwistWithCovariance read(MessageReader in) throws MessageException {
    return new TwistWithCovariance(in.nested("twist", Twist.CODEC), in.doubles("covariance", 36));
  }

  private static void write(TwistWithCovariance m, MessageWriter out) {
    Twist.CODEC.encode(m.twist, out);
    out.doubles(m.covariance);
  }
}
