package org.robotui.entity.pointcloud.internal;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Optional;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;

/**
 * The coordinates of a cloud as the graphics card takes them.
 *
 * @param xyz x, y, z in turn, in the frame of the cloud
 * @param order which point of the cloud each is
 */
record CloudPoints(FloatBuffer xyz, Order order) {
  /** Points of one display at most: 240 MB of coordinates. */
  static final int MOST = 20_000_000;

  private static final int FLOAT = 4;

  /** The coordinates, or none where the cloud has no fields x, y and z. */
  static Optional<CloudPoints> of(PointCloud cloud, long most) {
    Optional<PointField> x = cloud.field("x");
    Optional<PointField> y = cloud.field("y");
    Optional<PointField> z = cloud.field("z");
    if (x.isEmpty() || y.isEmpty() || z.isEmpty()) {
      return Optional.empty();
    }
    Order order = Order.of(cloud, Math.min(most, MOST));
    // On the heap, where the memory of clouds that are shown no more is free with the next collection, however many
    // come a second.
    float[] xyz = new float[3 * order.count()];
    PointField[] fields = {x.get(), y.get(), z.get()};
    ByteBuffer bytes = cloud.points().buffer(cloud.order());
    if (isPlain(fields) && order.contiguous()) {
      copyFloats(bytes, fields[0].offset(), order, xyz);
    } else {
      copyAny(bytes, fields, order, xyz);
    }
    return Optional.of(new CloudPoints(FloatBuffer.wrap(xyz), order));
  }

  /** Nearly all clouds: three floats in turn. */
  private static boolean isPlain(PointField... fields) {
    return fields[0].format() == PointField.Format.FLOAT32
        && fields[1].format() == PointField.Format.FLOAT32
        && fields[2].format() == PointField.Format.FLOAT32
        && fields[1].offset() == fields[0].offset() + FLOAT
        && fields[2].offset() == fields[1].offset() + FLOAT;
  }

  private static void copyFloats(ByteBuffer bytes, int offset, Order order, float... xyz) {
    int source = 0;
    for (int i = 0; i < xyz.length; i += 3) {
      int at = source * order.pointStep() + offset;
      xyz[i] = bytes.getFloat(at);
      xyz[i + 1] = bytes.getFloat(at + FLOAT);
      xyz[i + 2] = bytes.getFloat(at + 2 * FLOAT);
      source = order.after(source);
    }
  }

  private static void copyAny(ByteBuffer bytes, PointField[] fields, Order order, float... xyz) {
    int source = 0;
    for (int i = 0; i < order.count(); i++) {
      int at = order.offset(source);
      for (int axis = 0; axis < 3; axis++) {
        xyz[3 * i + axis] = (float) Numbers.read(bytes, at + fields[axis].offset(), fields[axis].format());
      }
      source = order.after(source);
    }
  }
}
