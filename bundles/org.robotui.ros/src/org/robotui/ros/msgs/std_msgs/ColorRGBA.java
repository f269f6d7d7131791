package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A colour ({@code std_msgs/ColorRGBA}).
 *
 * @param r red, 0 to 1
 * @param g green, 0 to 1
 * @param b blue, 0 to 1
 * @param a opacity, 0 to 1
 */
public record ColorRGBA(float r, float g, float b, float a) {

  /** Between records and bytes. */
  public static final RecordCodec<ColorRGBA> CODEC =
      RecordCodec.of("std_msgs/ColorRGBA", ColorRGBA::read, ColorRGBA::write);

  private static ColorRGBA read(MessageReader in) throws MessageException {
    return new ColorRGBA(in.float32("r"), in.float32("g"), in.float32("b"), in.float32("a"));
  }

  private static void write(ColorRGBA m, MessageWriter out) {
    out.f32(m.r);
    out.f32(m.g);
    out.f32(m.b);
    out.f32(m.a);
  }
}
