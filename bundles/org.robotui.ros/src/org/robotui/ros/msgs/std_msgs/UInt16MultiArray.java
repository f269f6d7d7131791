package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Integers in several dimensions ({@code std_msgs/UInt16MultiArray}).
 *
 * @param layout the dimensions
 * @param data   the bits of the unsigned elements
 */
public record UInt16MultiArray(MultiArrayLayout layout, short[] data) {

  /** Between records and bytes. */
  public static final RecordCodec<UInt16MultiArray> CODEC =
      RecordCodec.of("std_msgs/UInt16MultiArray", UInt16MultiArray::read, UInt16MultiArray::write);

  private static UInt16MultiArray read(MessageReader in) throws MessageException {
    return new UInt16MultiArray(
        in.nested("layout", MultiArrayLayout.CODEC),
        in.shorts("data", in.count("data", 2)));
  }

  private static void write(UInt16MultiArray m, MessageWriter out) {
    MultiArrayLayout.CODEC.encode(m.layout, out);
    out.array(m.data.length);
    for (short each : m.data) {
      out.i16(each);
    }
  }
}
