package org.robotui.ros.msgs.sensor_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * One field of the points of a {@link PointCloud2} ({@code sensor_msgs/PointField}).
 *
 * @param name     such as {@code x}
 * @param offset   bytes from the start of a point
 * @param datatype one of the constants, such as {@link #FLOAT32}
 * @param count    how many elements
 */
public record PointField(String name, long offset, int datatype, long count) {

  /** The constant {@code INT8} of the definition. */
  public static final int INT8 = 1;
  /** The constant {@code UINT8} of the definition. */
  public static final int UINT8 = 2;
  /** The constant {@code INT16} of the definition. */
  public static final int INT16 = 3;
  /** The constant {@code UINT16} of the definition. */
  public static final int UINT16 = 4;
  /** The constant {@code INT32} of the definition. */
  public static final int INT32 = 5;
  /** The constant {@code UINT32} of the definition. */
  public static final int UINT32 = 6;
  /** The constant {@code FLOAT32} of the definition. */
  public static final int FLOAT32 = 7;
  /** The constant {@code FLOAT64} of the definition. */
  public static final int FLOAT64 = 8;

  /** Between records and bytes. */
  public static final RecordCodec<PointField> CODEC =
      RecordCodec.of("sensor_msgs/PointField", PointField::read, PointField::write);

  private static PointField read(MessageReader in) throws MessageException {
    return new PointField(in.string("name"), in.uint32("offset"), in.uint8("datatype"), in.uint32("count"));
  }

  private static void write(PointField m, MessageWriter out) {
    out.string(m.name);
    out.i32((int) m.offset);
    out.u8(m.datatype);
    out.i32((int) m.count);
  }
}
