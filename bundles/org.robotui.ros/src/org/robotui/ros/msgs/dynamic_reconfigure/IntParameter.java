package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A whole number of a configuration ({@code dynamic_reconfigure/IntParameter}).
 *
 * @param name  the parameter
 * @param value its value
 */
public record IntParameter(String name, int value) {

  /** Between records and bytes. */
  public static final RecordCodec<IntParameter> CODEC =
      RecordCodec.of("dynamic_reconfigure/IntParameter", IntParameter::read, IntParameter::write);

  private static IntParameter read(MessageReader in) throws MessageException {
    return new IntParameter(in.string("name"), in.int32("value"));
  }

  private static void write(IntParameter m, MessageWriter out) {
    out.string(m.name);
    out.i32(m.value);
  }
}
