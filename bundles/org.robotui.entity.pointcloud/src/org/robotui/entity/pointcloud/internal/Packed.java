package org.robotui.entity.pointcloud.internal;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;

/** Colours packed into four bytes of a field, whatever its format says: alpha, red, green, blue from the highest. */
final class Packed {
  private static final int OPAQUE = 0xff;

  private Packed() {}

  static Optional<PointField> in(PointCloud cloud) {
    return Stream.of("rgb", "rgba").flatMap(name -> cloud.field(name).stream())
        .filter(f -> f.format().size() == Integer.BYTES).findFirst();
  }

  static ByteBuffer colors(PointCloud cloud, PointField field, Order order) {
    ByteBuffer bytes = cloud.points().buffer(cloud.order());
    ByteBuffer rgba = ByteBuffer.allocate(Integer.BYTES * order.count());
    boolean alpha = field.name().equals("rgba");
    int source = 0;
    for (int i = 0; i < order.count(); i++) {
      int argb = bytes.getInt(order.offset(source) + field.offset());
      rgba.putInt(Integer.BYTES * i, argb << Byte.SIZE | (alpha ? argb >>> 3 * Byte.SIZE : OPAQUE));
      source = order.after(source);
    }
    return rgba;
  }
}
