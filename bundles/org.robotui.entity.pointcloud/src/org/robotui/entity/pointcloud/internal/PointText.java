package org.robotui.entity.pointcloud.internal;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Properties;

/** What a selected point says: its place, and all its fields. */
record PointText(PointCloud cloud, Order order) implements Describer {
  private static final int FIELDS = 40;

  @Override
  public Properties describe(int element, Vector3 place) {
    if (element < 0 || element >= order.count()) {
      return Properties.of("point cloud");
    }
    int source = order.source(element);
    List<Properties.Entry> entries = new ArrayList<>();
    entries.add(new Properties.Entry("frame", cloud.frame().name()));
    ByteBuffer bytes = cloud.points().buffer(cloud.order());
    for (PointField field : cloud.fields().subList(0, Math.min(FIELDS, cloud.fields().size()))) {
      entries.add(new Properties.Entry(field.name(), value(bytes, order.offset(source) + field.offset(), field)));
    }
    return new Properties("point " + source + " of " + order.total(), entries);
  }

  private static String value(ByteBuffer bytes, int at, PointField field) {
    if (field.name().equals("rgb") || field.name().equals("rgba")) {
      return field.format().size() == Integer.BYTES ? String.format("#%06x", bytes.getInt(at) & 0xffffff) : "";
    }
    double number = Numbers.read(bytes, at, field.format());
    return List.of("x", "y", "z").contains(field.name())
        ? String.format(Locale.ROOT, "%.3f m", number)
        : String.format(Locale.ROOT, "%.6g", number);
  }
}
