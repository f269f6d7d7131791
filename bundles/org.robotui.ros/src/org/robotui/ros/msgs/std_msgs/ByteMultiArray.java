package org.robotui.ros.msgs.std_msgs;

import java.nio.ByteBuffer;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Signed bytes in several dimensions ({@code std_msgs/ByteMultiArray}).
 *
 * @param layout the dimensions
 * @param data   the elements
 */
public record ByteMultiArray(MultiArrayLayout layout, ByteBuffer data) {

  /** Between records and bytes. */
  public static final RecordCodec<ByteMultiArray> CODEC =
      RecordCodec.of("std_msgs/ByteMultiArray", ByteMultiArray::read, ByteMultiArray::write);

  /** Keeps read-only views of bytes. */
  public ByteMultiArray {
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

  private static ByteMultiArray read(MessageReader in) throws MessageException {
    return new ByteMultiArray(in.nested("layout", MultiArrayLayout.CODEC), in.bytes("data"));
  }

  private static void write(ByteMultiArray m, MessageWriter out) {
    MultiArrayLayout.CODEC.encode(m.layout, out);
    out.array(m.data.remaining()).bytes(m.data);
  }
}
