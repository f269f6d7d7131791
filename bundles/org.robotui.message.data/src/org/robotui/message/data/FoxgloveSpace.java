package org.robotui.message.data;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Floats;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;

/**
 * What the schemas of Foxglove say of space. There, scans, clouds and grids have a pose in their frame; scans and
 * clouds have none here, so it is applied to them.
 */
final class FoxgloveSpace {
  private static final double TINY = 1e-9;
  /** The order of {@code PackedElementField}, where 0 is unknown. */
  private static final List<String> TYPES =
      List.of("UNKNOWN", "UINT8", "INT8", "UINT16", "INT16", "UINT32", "INT32", "FLOAT32", "FLOAT64");
  private static final String OCCUPANCY = "occupancy";

  private FoxgloveSpace() {}

  static RigidTransform pose(NamedFields m) {
    org.robotui.message.ros.geometry_msgs.Vector3 p = FoxgloveTransforms.vector(m.inner("position"));
    return Geometry.transform(new Pose(new Point(p.x(), p.y(), p.z()),
        FoxgloveTransforms.rotation(m.inner("orientation"))));
  }

  /** The farthest echo stands for the limit that these scans do not have. */
  static LaserScan scan(NamedFields m, FrameNames names) {
    Floats ranges = m.floats("ranges");
    Floats intensities = m.floats("intensities");
    double farthest = 0;
    for (int i = 0; i < ranges.size(); i++) {
      farthest = Float.isFinite(ranges.get(i)) ? Math.max(farthest, ranges.get(i)) : farthest;
    }
    double start = m.number("start_angle");
    double step = ranges.size() > 1 ? (m.number("end_angle") - start) / (ranges.size() - 1) : 0;
    return new LaserScan(names.frame(m.text("frame_id")), start + yaw(pose(m.inner("pose"))), step, 0, farthest, 0,
        ranges, intensities.size() == ranges.size() ? intensities : Floats.EMPTY);
  }

  private static double yaw(RigidTransform pose) {
    Quaternion q = pose.rotation();
    Vector3 t = pose.translation();
    if (Math.abs(q.x()) + Math.abs(q.y()) + Math.abs(t.x()) + Math.abs(t.y()) + Math.abs(t.z()) > TINY) {
      throw new IllegalArgumentException("pose: a scan can only be turned about z in its frame, not moved by " + pose);
    }
    return 2 * Math.atan2(q.z(), q.w());
  }

  static PointCloud cloud(NamedFields m, FrameNames names) {
    List<PointField> fields = m.each("fields").stream().map(FoxgloveSpace::field).toList();
    Bytes data = m.bytes("data");
    int stride = m.size("point_stride");
    int count = stride == 0 ? 0 : data.size() / stride;
    PointCloud cloud = new PointCloud(names.frame(m.text("frame_id")), count, 1, fields, stride, count * stride,
        ByteOrder.LITTLE_ENDIAN, false, data);
    RigidTransform pose = pose(m.inner("pose"));
    return pose.equals(RigidTransform.IDENTITY) ? cloud : moved(cloud, pose);
  }

  private static PointField field(NamedFields m) {
    int type = m.choice("type", TYPES);
    if (type == 0) {
      throw new IllegalArgumentException("field " + m.text("name") + ": has no type that is known");
    }
    return new PointField(m.text("name"), m.size("offset"), PointField.Format.valueOf(TYPES.get(type)), 1);
  }

  private static PointCloud moved(PointCloud cloud, RigidTransform pose) {
    int[] at = List.of("x", "y", "z").stream().mapToInt(axis -> coordinate(cloud, axis)).toArray();
    ByteBuffer all = ByteBuffer.allocate(cloud.points().size()).order(ByteOrder.LITTLE_ENDIAN);
    all.put(cloud.points().buffer(ByteOrder.LITTLE_ENDIAN)).flip();
    for (int start = 0; start < cloud.rowStep(); start += cloud.pointStep()) {
      Vector3 point = pose.apply(new Vector3(all.getFloat(start + at[0]), all.getFloat(start + at[1]),
          all.getFloat(start + at[2])));
      all.putFloat(start + at[0], (float) point.x()).putFloat(start + at[1], (float) point.y())
          .putFloat(start + at[2], (float) point.z());
    }
    return new PointCloud(cloud.frame(), cloud.width(), 1, cloud.fields(), cloud.pointStep(), cloud.rowStep(),
        ByteOrder.LITTLE_ENDIAN, false, Bytes.wrap(all));
  }

  private static int coordinate(PointCloud cloud, String axis) {
    return cloud.field(axis).filter(f -> f.format() == PointField.Format.FLOAT32).map(PointField::offset).orElseThrow(
        () -> new IllegalArgumentException("field " + axis + ": must be FLOAT32 in a cloud that has a pose"));
  }

  /** A grid may hold anything; one of a map has its occupancy in a byte, in percent, or less than 0 where unknown. */
  static GridMap grid(NamedFields m, FrameNames names) {
    NamedFields cell = m.inner("cell_size");
    if (Math.abs(cell.number("x") - cell.number("y")) > TINY) {
      throw new IllegalArgumentException("cell_size: a map has square cells, not " + cell.number("x") + " x "
          + cell.number("y"));
    }
    int offset = occupancy(m.each("fields").stream().map(FoxgloveSpace::field).toList()).offset();
    int columns = m.size("column_count");
    int rowStride = m.size("row_stride");
    Bytes data = m.bytes("data");
    int rows = rowStride == 0 ? 0 : data.size() / rowStride;
    byte[] cells = cells(data, rows, columns, rowStride, m.size("cell_stride"), offset);
    return new GridMap(names.frame(m.text("frame_id")), cell.number("x"), columns, rows, pose(m.inner("pose")),
        Bytes.wrap(cells, 0, cells.length));
  }

  private static byte[] cells(Bytes data, int rows, int columns, int rowStride, int cellStride, int offset) {
    if ((long) columns * cellStride > rowStride || offset >= Math.max(1, cellStride) || cellStride == 0) {
      throw new IllegalArgumentException("row_stride: " + rowStride + " bytes hold no " + columns + " cells of "
          + cellStride + " bytes");
    }
    byte[] cells = new byte[rows * columns];
    for (int i = 0; i < cells.length; i++) {
      cells[i] = data.get(i / columns * rowStride + i % columns * cellStride + offset);
    }
    return cells;
  }

  private static PointField occupancy(List<PointField> fields) {
    Optional<PointField> named = fields.stream().filter(f -> f.name().equals(OCCUPANCY)).findFirst();
    return named.or(() -> fields.stream().filter(f -> fields.size() == 1).findFirst())
        .filter(f -> f.format().size() == 1).orElseThrow(() -> new IllegalArgumentException(
            "fields: a map has its occupancy in one byte, the only one or named '" + OCCUPANCY + "'"));
  }
}
