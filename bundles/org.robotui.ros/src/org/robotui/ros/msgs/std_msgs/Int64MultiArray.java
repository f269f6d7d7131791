package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Integers in several dimensions ({@code std_msgs/Int64MultiArray}).
 *
 * @param layout the dimensions
 * @param data   the elements
 */
public record Int64MultiArray(MultiArrayLayout layout, long[] data) {

  /** Between records and bytes. */
  public static final RecordCodec<Int64MultiArray> CODEC =
      RecordCodec.of("std_msgs/Int64MultiArray", Int64MultiArray::read, Int64MultiArray::write);

  private static Int64MultiArray read(MessageReader in) throws MessageException {
    return new Int64MultiArray(
        in.nested("layout", MultiArrayLayout.CODEC),
        in.longs("data", in.count("data", 8)));
  }

  private static void write(Int64MultiArray m, MessageWriter out) {
    MultiArrayLayout.CODEC.encode(m.layout, out);
    out.array(m.data.length);
    for (long each : m.data) {
      out.i64(each);
    }
  }
}
