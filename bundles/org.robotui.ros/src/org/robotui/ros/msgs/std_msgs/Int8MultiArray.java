package org.robotui.ros.msgs.std_msgs;

import java.nio.ByteBuffer;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Signed bytes in several dimensions ({@code std_msgs/Int8MultiArray}).
 *
 * @param layout the dimensions
 * @param data   the elements
 */
public record Int8MultiArray(MultiArrayLayout layout, ByteBuffer data) {

  /** Between records and bytes. */
  public static final RecordCodec<Int8MultiArray> CODEC =
      RecordCodec.of("std_msgs/Int8MultiArray", Int8MultiArray::read, Int8MultiArray::write);

  /** Keeps read-only views of bytes. */
  public Int8MultiArray {
    data = data.slice().asReadOnlyBuffer();
  }

  /**
   * The bytes, without a copy.
   *
   * @return a fresh read-only view
   */
  @Override
  public ByteBuffer data() {
    return data.duplicate();
  }

  private static Int8MultiArray read(MessageReader in) throws MessageException {
    return new Int8MultiArray(in.nested("layout", MultiArrayLayout.CODEC), in.bytes("data"));
  }

  private static void write(Int8MultiArray m, MessageWriter out) {
    MultiArrayLayout.CODEC.encode(m.layout, out);
    out.array(m.data.remaining()).bytes(m.data);
  }
}
