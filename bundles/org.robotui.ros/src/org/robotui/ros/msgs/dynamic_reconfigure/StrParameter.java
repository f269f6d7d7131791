package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A text of a configuration ({@code dynamic_reconfigure/StrParameter}).
 *
 * @param name  the parameter
 * @param value its value
 */
public record StrParameter(String name, String value) {

  /** Between records and bytes. */
  public static final RecordCodec<StrParameter> CODEC =
      RecordCodec.of("dynamic_reconfigure/StrParameter", StrParameter::read, StrParameter::write);

  private static StrParameter read(MessageReader in) throws MessageException {
    return new StrParameter(in.string("name"), in.string("value"));
  }

  private static void write(StrParameter m, MessageWriter out) {
    out.string(m.name);
    out.string(m.value);
  }
}
