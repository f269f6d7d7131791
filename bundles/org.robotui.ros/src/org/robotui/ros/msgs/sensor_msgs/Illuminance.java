package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A brightness ({@code sensor_msgs/Illuminance}).
 *
 * @param header      time and frame
 * @param illuminance lux
 * @param variance    squared lux, 0 if not known
 */
public record Illuminance(Header header, double illuminance, double variance) {

  /** Between records and bytes. */
  public static final RecordCodec<Illuminance> CODEC =
      RecordCodec.of("sensor_msgs/Illuminance", Illuminance::read, Illuminance::write);

  private static Illuminance read(MessageReader in) throws MessageException {
    return new Illuminance(in.nested("header", Header.CODEC), in.float64("illuminance"), in.float64("variance"));
  }

  private static void write(Illuminance m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.f64(m.illuminance);
    out.f64(m.variance);
  }
}
