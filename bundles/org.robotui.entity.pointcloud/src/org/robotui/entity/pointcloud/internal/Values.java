package org.robotui.entity.pointcloud.internal;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** A number for each point, and the colours of such numbers. */
final class Values {
  private static final int STEPS = 1024;
  private static final int OPAQUE = 0xff;
  /** The colour of points whose number is none. */
  private static final int NOTHING = 0x808080ff;

  private Values() {}

  /** The numbers of a field in the order of the points. */
  static float[] of(PointCloud cloud, PointField field, Order order) {
    ByteBuffer bytes = cloud.points().buffer(cloud.order());
    float[] values = new float[order.count()];
    PointField.Format format = field.format();
    int source = 0;
    for (int i = 0; i < values.length; i++) {
      values[i] = (float) Numbers.read(bytes, order.offset(source) + field.offset(), format);
      source = order.after(source);
    }
    return values;
  }

  /** A coordinate of each point, in the frame that a transform leads to. */
  static float[] along(int axis, FloatBuffer xyz, RigidTransform frameFromCloud) {
    float[] values = new float[xyz.remaining() / 3];
    Vector3 unit = new Vector3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
    Vector3 row = frameFromCloud.rotation().inverse().rotate(unit);
    float rx = (float) row.x();
    float ry = (float) row.y();
    float rz = (float) row.z();
    float from = (float) frameFromCloud.translation().dot(unit);
    for (int i = 0; i < values.length; i++) {
      values[i] = rx * xyz.get(3 * i) + ry * xyz.get(3 * i + 1) + rz * xyz.get(3 * i + 2) + from;
    }
    return values;
  }

  /** The colours of numbers: between limits that are set, else between their own least and greatest. */
  static ByteBuffer colors(float[] values, PointStyle look) {
    Range own = look.min().isPresent() && look.max().isPresent() ? Range.NONE : Range.of(values);
    float low = look.min().map(Double::floatValue).orElse(own.least());
    float high = look.max().map(Double::floatValue).orElse(own.greatest());
    int[] table = look.colors().table(STEPS, look.reverse());
    float scale = high > low ? (STEPS - 1) / (high - low) : 0;
    ByteBuffer rgba = ByteBuffer.allocate(Integer.BYTES * values.length);
    for (int i = 0; i < values.length; i++) {
      float at = (values[i] - low) * scale;
      rgba.putInt(Integer.BYTES * i,
          at != at ? NOTHING : table[Math.min(Math.max((int) at, 0), STEPS - 1)] << Byte.SIZE | OPAQUE);
    }
    return rgba;
  }

  /** The least and the greatest finite number; the other way round where there is none. */
  private record Range(float least, float greatest) {
    static final Range NONE = new Range(Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY);

    static Range of(float... values) {
      float least = NONE.least;
      float greatest = NONE.greatest;
      for (float value : values) {
        least = value < least && value > Float.NEGATIVE_INFINITY ? value : least;
        greatest = value > greatest && value < Float.POSITIVE_INFINITY ? value : greatest;
      }
      return new Range(least, greatest);
    }
  }
}
