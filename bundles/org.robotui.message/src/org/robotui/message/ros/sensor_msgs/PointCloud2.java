package org.robotui.message.ros.sensor_msgs;

import java.nio.ByteBuffer;
import java.util.List;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Points of any fields ({@code sensor_msgs/PointCloud2}).
 *
 * @param header time and frame
 * @param height rows; 1 for an unordered cloud
 * @param width points of a row
 * @param fields what a point holds
 * @param isBigendian whether numbers are big-endian
 * @param pointStep bytes of a point
 * @param rowStep bytes of a row
 * @param data {@code row_step * height} bytes
 * @param isDense whether all points are valid
 */
@MessageType("sensor_msgs/PointCloud2")
public record PointCloud2(
    Header header, long height, long width, List<PointField> fields, boolean isBigendian, long pointStep, long rowStep,
    ByteBuffer data, boolean isDense) {

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
}
