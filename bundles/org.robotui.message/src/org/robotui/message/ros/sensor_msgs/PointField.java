package org.robotui.message.ros.sensor_msgs;

import org.robotui.message.MessageType;

/**
 * One field of the points of a {@link PointCloud2} ({@code sensor_msgs/PointField}).
 *
 * @param name such as {@code x}
 * @param offset bytes from the start of a point
 * @param datatype one of the constants, such as {@link #FLOAT32}
 * @param count how many elements
 */
@MessageType("sensor_msgs/PointField")
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
}
