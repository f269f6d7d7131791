package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A humidity ({@code sensor_msgs/RelativeHumidity}).
 *
 * @param header           time and frame
 * @param relativeHumidity 0 to 1
 * @param variance         squared, 0 if not known
 */
public record RelativeHumidity(Header header, double relativeHumidity, double variance) {

  /** Between records and bytes. */
  public static final RecordCodec<RelativeHumidity> CODEC =
      RecordCodec.of("sensor_msgs/RelativeHumidity", RelativeHumidity::read, RelativeHumidity::write);

  private static RelativeHumidity read(MessageReader in) throws MessageException {
    return new RelativeHumidity(
        in.nested("header", Header.CODEC),
        in.float64("relative_humidity"),
        in.float64("variance"));
  }

  private static void write(RelativeHumidity m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.f64(m.relativeHumidity);
    out.f64(m.variance);
  }
}
