package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Numbers in several dimensions ({@code std_msgs/Float32MultiArray}).
 *
 * @param layout the dimensions
 * @param data   the elements
 */
public record Float32MultiArray(MultiArrayLayout layout, float[] data) {

  /** Between records and bytes. */
  public static final RecordCodec<Float32MultiArray> CODEC =
      RecordCodec.of("std_msgs/Float32MultiArray", Float32MultiArray::read, Float32MultiArray::write);

  private static Float32MultiArray read(MessageReader in) throws MessageException {
    return new Float32MultiArray(
        in.nested("layout", MultiArrayLayout.CODEC),
        in.floats("data", in.count("data", 4)));
  }

  private static void write(Float32MultiArray m, MessageWriter out) {
    MultiArrayLayout.CODEC.encode(m.layout, out);
    out.array(m.data.length).floats(m.data);
  }
}
