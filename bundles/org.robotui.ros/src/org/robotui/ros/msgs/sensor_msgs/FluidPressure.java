package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A pressure ({@code sensor_msgs/FluidPressure}).
 *
 * @param header        time and frame
 * @param fluidPressure pascals
 * @param variance      squared pascals, 0 if not known
 */
public record FluidPressure(Header header, double fluidPressure, double variance) {

  /** Between records and bytes. */
  public static final RecordCodec<FluidPressure> CODEC =
      RecordCodec.of("sensor_msgs/FluidPressure", FluidPressure::read, FluidPressure::write);

  private static FluidPressure read(MessageReader in) throws MessageException {
    return new FluidPressure(
        in.nested("header", Header.CODEC),
        in.float64("fluid_pressure"),
        in.float64("variance"));
  }

  private static void write(FluidPressure m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.f64(m.fluidPressure);
    out.f64(m.variance);
  }
}
