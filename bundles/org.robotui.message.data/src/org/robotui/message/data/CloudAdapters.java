package org.robotui.message.data;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.robotui.data.array.Bytes;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.message.ros.geometry_msgs.Point32;
import org.robotui.message.ros.sensor_msgs.ChannelFloat32;
import org.robotui.message.ros.sensor_msgs.PointCloud2;

/** Point clouds, of the present and of the old message. */
final class CloudAdapters {
  private CloudAdapters() {}

  static List<Adapter<?, ?>> all() {
    return List.of(
        Adapter.of(PointCloud2.class, PointCloud.class, CloudAdapters::cloud,
            m -> m.header().stamp()),
        Adapter.of(org.robotui.message.ros.sensor_msgs.PointCloud.class, PointCloud.class,
            CloudAdapters::oldCloud, m -> m.header().stamp()));
  }

  private static PointCloud cloud(PointCloud2 m, FrameNames names) {
    List<PointField> fields = m.fields().stream().map(CloudAdapters::field).toList();
    ByteOrder order = m.isBigendian() ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    return new PointCloud(names.frame(m.header().frameId()), Sizes.of("width", m.width()),
        Sizes.of("height", m.height()),
        fields, Sizes.of("point_step", m.pointStep()), Sizes.of("row_step", m.rowStep()), order, m.isDense(),
        Bytes.wrap(m.data()));
  }

  private static PointField field(org.robotui.message.ros.sensor_msgs.PointField f) {
    PointField.Format[] formats = PointField.Format.values();
    if (f.datatype() < 1 || f.datatype() > formats.length) {
      throw new IllegalArgumentException("field " + f.name() + ": datatype " + f.datatype() + " is none of 1 to 8");
    }
    int count = Math.max(1, Sizes.of("count", f.count()));
    return new PointField(f.name(), Sizes.of("offset", f.offset()), formats[f.datatype() - 1], count);
  }

  private static PointCloud oldCloud(org.robotui.message.ros.sensor_msgs.PointCloud m, FrameNames names) {
    List<ChannelFloat32> channels =
        m.channels().stream().filter(c -> c.values().length == m.points().size()).toList();
    List<PointField> fields = new ArrayList<>();
    List.of("x", "y", "z").forEach(axis -> fields.add(floatField(axis, fields.size())));
    channels.forEach(c -> fields.add(floatField(c.name(), fields.size())));
    int step = fields.size() * Float.BYTES;
    ByteBuffer points = ByteBuffer.allocate(Math.multiplyExact(step, m.points().size())).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < m.points().size(); i++) {
      Point32 p = m.points().get(i);
      points.putFloat(p.x()).putFloat(p.y()).putFloat(p.z());
      for (ChannelFloat32 c : channels) {
        points.putFloat(c.values()[i]);
      }
    }
    return new PointCloud(names.frame(m.header().frameId()), m.points().size(), 1, fields, step, points.capacity(),
        ByteOrder.LITTLE_ENDIAN, false, Bytes.wrap(points.flip()));
  }

  private static PointField floatField(String name, int index) {
    return new PointField(name, index * Float.BYTES, PointField.Format.FLOAT32, 1);
  }
}
