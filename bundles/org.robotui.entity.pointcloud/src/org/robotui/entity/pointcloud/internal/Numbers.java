package org.robotui.entity.pointcloud.internal;

import java.nio.ByteBuffer;
import org.robotui.data.sensor.PointField;

/** Reads the first number of a field, whatever its format. */
final class Numbers {
  private static final long UNSIGNED = 0xffff_ffffL;

  private Numbers() {}

  /** The number at a place of a buffer that has the byte order of the cloud. */
  static double read(ByteBuffer bytes, int at, PointField.Format format) {
    return switch (format) {
      case INT8 -> bytes.get(at);
      case UINT8 -> bytes.get(at) & 0xff;
      case INT16 -> bytes.getShort(at);
      case UINT16 -> bytes.getShort(at) & 0xffff;
      case INT32 -> bytes.getInt(at);
      case UINT32 -> bytes.getInt(at) & UNSIGNED;
      case FLOAT32 -> bytes.getFloat(at);
      case FLOAT64 -> bytes.getDouble(at);
    };
  }
}
