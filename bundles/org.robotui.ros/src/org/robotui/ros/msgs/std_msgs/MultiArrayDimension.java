package org.robotui.ros.msgs.std_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * One dimension of an array ({@code std_msgs/MultiArrayDimension}).
 *
 * @param label  its name
 * @param size   its length, elements
 * @param stride elements from one index of this dimension to the end of it
 */
public record MultiArrayDimension(String label, long size, long stride) {

  /** Between records and bytes. */
  public static final RecordCodec<MultiArrayDimension> CODEC =
      RecordCodec.of("std_msgs/MultiArrayDimension", MultiArrayDimension::read, MultiArrayDimension::write);

  private static MultiArrayDimension read(MessageReader in) throws MessageException {
    return new MultiArrayDimension(in.string("label"), in.uint32("size"), in.uint32("stride"));
  }

  private static void write(MultiArrayDimension m, MessageWriter out) {
    out.string(m.label);
    out.i32((int) m.size);
    out.i32((int) m.stride);
  }
}
