package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A number of a configuration ({@code dynamic_reconfigure/DoubleParameter}).
 *
 * @param name  the parameter
 * @param value its value
 */
public record DoubleParameter(String name, double value) {

  /** Between records and bytes. */
  public static final RecordCodec<DoubleParameter> CODEC =
      RecordCodec.of("dynamic_reconfigure/DoubleParameter", DoubleParameter::read, DoubleParameter::write);

  private static DoubleParameter read(MessageReader in) throws MessageException {
    return new DoubleParameter(in.string("name"), in.float64("value"));
  }

  private static void write(DoubleParameter m, MessageWriter out) {
    out.string(m.name);
    out.f64(m.value);
  }
}
