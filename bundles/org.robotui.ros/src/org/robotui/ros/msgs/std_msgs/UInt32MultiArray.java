package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Integers in several dimensions ({@code std_msgs/UInt32MultiArray}).
 *
 * @param layout the dimensions
 * @param data   the bits of the unsigned elements
 */
public record UInt32MultiArray(MultiArrayLayout layout, int[] data) {

  /** Between records and bytes. */
  public static final RecordCodec<UInt32MultiArray> CODEC =
      RecordCodec.of("std_msgs/UInt32MultiArray", UInt32MultiArray::read, UInt32MultiArray::write);

  private static UInt32MultiArray read(MessageReader in) throws MessageException {
    return new UInt32MultiArray(
        in.nested("layout", MultiArrayLayout.CODEC),
        in.ints("data", in.count("data", 4)));
  }

  private static void write(UInt32MultiArray m, MessageWriter out) {
    MultiArrayLayout.CODEC.encode(m.layout, out);
    out.array(m.data.length).ints(m.data);
  }
}
