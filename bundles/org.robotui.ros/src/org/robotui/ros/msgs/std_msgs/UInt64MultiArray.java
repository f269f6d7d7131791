package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Integers in several dimensions ({@code std_msgs/UInt64MultiArray}).
 *
 * @param layout the dimensions
 * @param data   the bits of the unsigned elements
 */
public record UInt64MultiArray(MultiArrayLayout layout, long[] data) {

  /** Between records and bytes. */
  public static final RecordCodec<UInt64MultiArray> CODEC =
      RecordCodec.of("std_msgs/UInt64MultiArray", UInt64MultiArray::read, UInt64MultiArray::write);

  private static UInt64MultiArray read(MessageReader in) throws MessageException {
    return new UInt64MultiArray(
        in.nested("layout", MultiArrayLayout.CODEC),
        in.longs("data", in.count("data", 8)));
  }

  private static void write(UInt64MultiArray m, MessageWriter out) {
    MultiArrayLayout.CODEC.encode(m.layout, out);
    out.array(m.data.length);
    for (long each : m.data) {
      out.i64(each);
    }
  }
}
