package org.robotui.ros.msgs.std_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * How the elements of a multi-dimensional array lie in its data ({@code std_msgs/MultiArrayLayout}).
 *
 * @param dim        the dimensions, outermost first
 * @param dataOffset elements of padding before the first
 */
public record MultiArrayLayout(List<MultiArrayDimension> dim, long dataOffset) {

  /** Between records and bytes. */
  public static final RecordCodec<MultiArrayLayout> CODEC =
      RecordCodec.of("std_msgs/MultiArrayLayout", MultiArrayLayout::read, MultiArrayLayout::write);

  /** Keeps immutable copies of lists. */
  public MultiArrayLayout {
    dim = List.copyOf(dim);
  }

  private static MultiArrayLayout read(MessageReader in) throws MessageException {
    return new MultiArrayLayout(in.list("dim", MultiArrayDimension.CODEC), in.uint32("data_offset"));
  }

  private static void write(MultiArrayLayout m, MessageWriter out) {
    MultiArrayDimension.CODEC.encodeAll(m.dim, out);
    out.i32((int) m.dataOffset);
  }
}
