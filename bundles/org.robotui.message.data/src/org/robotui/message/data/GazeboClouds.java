package org.robotui.message.data;

import java.nio.ByteOrder;
import java.util.List;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;

/** Point clouds of Gazebo, which are packed as those of ROS, with other names of types. */
final class GazeboClouds {
  private static final List<String> TYPES =
      List.of("INT8", "UINT8", "INT16", "UINT16", "INT32", "UINT32", "FLOAT32", "FLOAT64");

  private GazeboClouds() {}

  static PointCloud cloud(NamedFields m, FrameNames names) {
    List<PointField> fields = m.each("field").stream()
        .map(f -> new PointField(f.text("name"), f.size("offset"),
            PointField.Format.valueOf(TYPES.get(f.choice("datatype", TYPES))), Math.max(1, f.size("count"))))
        .toList();
    ByteOrder order = m.flag("is_bigendian") ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    return new PointCloud(GazeboAdapters.frame(m, names), m.size("width"), m.size("height"), fields,
        m.size("point_step"), m.size("row_step"), order, m.flag("is_dense"), m.bytes("data"));
  }
}
