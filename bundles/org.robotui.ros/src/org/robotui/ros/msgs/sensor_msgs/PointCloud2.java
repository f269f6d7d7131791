package org.robotui.ros.msgs.sensor_msgs;

import java.nio.ByteBuffer;
import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Points of any fields ({@code sensor_msgs/PointCloud2}).
 *
 * @param header      time and frame
 * @param height      rows; 1 for an unordered cloud
 * @param width       points of a row
 * @param fields      what a point holds
 * @param isBigendian whether numbers are big-endian
 * @param pointStep   bytes of a point
 * @param rowStep     bytes of a row
 * @param data        {@code row_step * height} bytes
 * @param isDense     whether all points are valid
 */
public record PointCloud2(
    Header header, long height, long width, List<PointField> fields, boolean isBigendian, long pointStep, long
    rowStep, ByteBuffer data, boolean isDense) {

  /** Between records and bytes. */
  public static final RecordCodec<PointCloud2> CODEC =
      RecordCodec.of("sensor_msgs/PointCloud2", PointCloud2::read, PointCloud2::write);

  /** Keeps immutable copies of lists and read-only views of bytes. */
  public PointCloud2 {
    fields = List.copyOf(fields);
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

  private static PointCloud2 read(MessageReader in) throws MessageException {
    return new PointCloud2(
        in.nested("header", Header.CODEC),
        in.uint32("height"),
        in.uint32("width"),
        in.list("fields", PointField.CODEC),
        in.bool("is_bigendian"),
        in.uint32("point_step"),
        in.uint32("row_step"),
        in.bytes("data"),
        in.bool("is_dense"));
  }

  private static void write(PointCloud2 m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.i32((int) m.height);
    out.i32((int) m.width);
    PointField.CODEC.encodeAll(m.fields, out);
    out.bool(m.isBigendian);
    out.i32((int) m.pointStep);
    out.i32((int) m.rowStep);
    out.array(m.data.remaining()).bytes(m.data);
    out.bool(m.isDense);
  }
}
