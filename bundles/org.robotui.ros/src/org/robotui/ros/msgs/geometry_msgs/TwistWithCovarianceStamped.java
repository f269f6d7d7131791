package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * An uncertain velocity with time and frame ({@code geometry_msgs/TwistWithCovarianceStamped}).
 *
 * @param header time and frame
 * @param twist  the velocity
 */
public record TwistWithCovarianceStamped(Header header, TwistWithCovariance twist) {

  /** Between records and bytes. */
  public static final RecordCodec<TwistWithCovarianceStamped> CODEC =
      RecordCodec.of("geometry_msgs/TwistWithCovarianceStamped", TwistWithCovarianceStamped::read, TwistWithCovarianceStamped::write);

  private static TwistWithCovarianceStamped read(MessageReader in) throws MessageException {
    return new TwistWithCovarianceStamped(
        in.nested("header", Header.CODEC),
        in.nested("twist", TwistWithCovariance.CODEC));
  }

  private static void write(TwistWithCovarianceStamped m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    TwistWithCovariance.CODEC.encode(m.twist, out);
  }
}
