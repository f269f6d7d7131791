package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A temperature ({@code sensor_msgs/Temperature}).
 *
 * @param header      time and frame
 * @param temperature degrees Celsius
 * @param variance    squared degrees Celsius, 0 if not known
 */
public record Temperature(Header header, double temperature, double variance) {

  /** Between records and bytes. */
  public static final RecordCodec<Temperature> CODEC =
      RecordCodec.of("sensor_msgs/Temperature", Temperature::read, Temperature::write);

  private static Temperature read(MessageReader in) throws MessageException {
    return new Temperature(in.nested("header", Header.CODEC), in.float64("temperature"), in.float64("variance"));
  }

  private static void write(Temperature m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.f64(m.temperature);
    out.f64(m.variance);
  }
}
