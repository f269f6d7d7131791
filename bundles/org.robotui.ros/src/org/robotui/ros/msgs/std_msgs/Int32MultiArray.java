package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Integers in several dimensions ({@code std_msgs/Int32MultiArray}).
 *
 * @param layout the dimensions
 * @param data   the elements
 */
public record Int32MultiArray(MultiArrayLayout layout, int[] data) {

  /** Between records and bytes. */
  public static final RecordCodec<Int32MultiArray> CODEC =
      RecordCodec.of("std_msgs/Int32MultiArray", Int32MultiArray::read, Int32MultiArray::write);

  private static Int32MultiArray read(MessageReader in) throws MessageException {
    return new Int32MultiArray(in.nested("layout", MultiArrayLayout.CODEC), in.ints("data", in.count("data", 4)));
  }

  private static void write(Int32MultiArray m, MessageWriter out) {
    MultiArrayLayout.CODEC.encode(m.layout, out);
    out.array(m.data.length).ints(m.data);
  }
}
