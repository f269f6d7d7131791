package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Numbers in several dimensions ({@code std_msgs/Float64MultiArray}).
 *
 * @param layout the dimensions
 * @param data   the elements
 */
public record Float64MultiArray(MultiArrayLayout layout, double[] data) {

  /** Between records and bytes. */
  public static final RecordCodec<Float64MultiArray> CODEC =
      RecordCodec.of("std_msgs/Float64MultiArray", Float64MultiArray::read, Float64MultiArray::write);

  private static Float64MultiArray read(MessageReader in) throws MessageException {
    return new Float64MultiArray(
        in.nested("layout", MultiArrayLayout.CODEC),
        in.doubles("data", in.count("data", 8)));
  }

  private static void write(Float64MultiArray m, MessageWriter out) {
    MultiArrayLayout.CODEC.encode(m.layout, out);
    out.array(m.data.length).doubles(m.data);
  }
}
