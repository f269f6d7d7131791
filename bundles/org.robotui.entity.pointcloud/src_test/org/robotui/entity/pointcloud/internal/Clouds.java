package org.robotui.entity.pointcloud.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.robotui.data.array.Bytes;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.testkit.display.FakePlaces;

/** Clouds of tests. */
final class Clouds {
  private Clouds() {}

  static PointField field(String name, int offset, PointField.Format format) {
    return new PointField(name, offset, format, 1);
  }

  /** x, y, z and intensity as floats; a row of points along x, intensity counting. */
  static PointCloud line(int count) {
    ByteBuffer bytes = ByteBuffer.allocate(16 * count).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < count; i++) {
      bytes.putFloat(i).putFloat(0.5f).putFloat(-i).putFloat(10 * i);
    }
    return plain(count, bytes, "intensity");
  }

  /** x, y, z and another float. */
  static PointCloud plain(int count, ByteBuffer bytes, String fourth) {
    List<PointField> fields =
        List.of(field("x", 0, PointField.Format.FLOAT32), field("y", 4, PointField.Format.FLOAT32),
            field("z", 8, PointField.Format.FLOAT32), field(fourth, 12, PointField.Format.FLOAT32));
    return new PointCloud(FakePlaces.frame("lidar"), count, 1, fields, 16, 16 * count, bytes.order(), true,
        Bytes.wrap(bytes.array(), 0, 16 * count));
  }
}
