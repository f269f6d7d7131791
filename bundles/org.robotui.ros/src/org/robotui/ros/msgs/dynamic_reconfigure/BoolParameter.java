package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A truth value of a configuration ({@code dynamic_reconfigure/BoolParameter}).
 *
 * @param name  the parameter
 * @param value its value
 */
public record BoolParameter(String name, boolean value) {

  /** Between records and bytes. */
  public static final RecordCodec<BoolParameter> CODEC =
      RecordCodec.of("dynamic_reconfigure/BoolParameter", BoolParameter::read, BoolParameter::write);

  private static BoolParameter read(MessageReader in) throws MessageException {
    return new BoolParameter(in.string("name"), in.bool("value"));
  }

  private static void write(BoolParameter m, MessageWriter out) {
    out.string(m.name);
    out.bool(m.value);
  }
}
