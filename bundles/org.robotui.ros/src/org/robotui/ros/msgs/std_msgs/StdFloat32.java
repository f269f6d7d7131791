package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A number ({@code std_msgs/Float32}).
 *
 * @param data the value
 */
public record StdFloat32(float data) {

  /** Between records and bytes. */
  public static final RecordCodec<StdFloat32> CODEC =
      RecordCodec.of("std_msgs/Float32", StdFloat32::read, StdFloat32::write);

  private static StdFloat32 read(MessageReader in) throws MessageException {
    return new StdFloat32(in.float32("data"));
  }

  private static void write(StdFloat32 m, MessageWriter out) {
    out.f32(m.data);
  }
}
