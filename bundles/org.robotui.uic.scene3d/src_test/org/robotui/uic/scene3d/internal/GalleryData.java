package org.robotui.uic.scene3d.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.FakeFrames;

/** A room with a robot in it. */
final class GalleryData {
  private static final FrameId MAP = frame("map");
  private static final FrameId BASE = frame("base_link");
  private static final FrameId LASER = frame("laser");
  private static final double HALF = 4;
  private static final int BEAMS = 541;

  private GalleryData() {}

  static FrameId frame(String name) {
    return new FrameId("Keira", name);
  }

  static void frames(FakeFrames frames) {
    frames.fix(MAP, frame("odom"), RigidTransform.IDENTITY);
    frames.fix(frame("odom"), BASE, RigidTransform.planar(1, -0.5, 0.6));
    frames.fix(BASE, LASER, new RigidTransform(new Vector3(0.2, 0, 0.3), Quaternion.IDENTITY));
  }

  static Map<SourceId, Data> all(int points) {
    Map<SourceId, Data> all = new LinkedHashMap<>();
    all.put(new SourceId("base", "/map"), map());
    all.put(new SourceId("base", "/scan"), scan());
    all.put(new SourceId("base", "/lidar/points"), cloud(points));
    all.put(new SourceId("base", "/plan"), new Path(MAP, IntStream.range(0, 40)
        .mapToObj(i -> RigidTransform.planar(1 - i * 0.08, -0.5 + 2 * Math.sin(i * 0.06), 2.5)).toList()));
    all.put(new SourceId("base", "/odom"), odometry());
    return all;
  }

  private static Odometry odometry() {
    double[] covariance = new double[Odometry.COVARIANCE_SIZE];
    covariance[0] = 0.04;
    covariance[7] = 0.01;
    covariance[35] = 0.02;
    return new Odometry(frame("odom"), BASE, RigidTransform.planar(1, -0.5, 0.6), Doubles.wrap(covariance),
        new Vector3(0.4, 0, 0),
        Vector3.ZERO, Doubles.EMPTY);
  }

  private static GridMap map() {
    int size = 180;
    byte[] cells = new byte[size * size];
    Arrays.fill(cells, (byte) -1);
    for (int y = 10; y < size - 10; y++) {
      for (int x = 10; x < size - 10; x++) {
        boolean edge = x < 13 || y < 13 || x > size - 14 || y > size - 14;
        cells[y * size + x] = (byte) (edge ? 100 : 0);
      }
    }
    return new GridMap(MAP, 0.05, size, size, RigidTransform.planar(-4.5, -4.5, 0), Bytes.wrap(cells, 0, cells.length));
  }

  private static LaserScan scan() {
    float[] ranges = new float[BEAMS];
    RigidTransform at = RigidTransform.planar(1, -0.5, 0.6).times(RigidTransform.planar(0.2, 0, 0));
    for (int i = 0; i < BEAMS; i++) {
      double angle = at.rotation().yaw() - Math.toRadians(135) + Math.toRadians(i * 0.5);
      double dx = Math.cos(angle);
      double dy = Math.sin(angle);
      double alongX = ((dx > 0 ? HALF : -HALF) - at.translation().x()) / dx;
      double alongY = ((dy > 0 ? HALF : -HALF) - at.translation().y()) / dy;
      ranges[i] = (float) Math.min(alongX, alongY);
    }
    return new LaserScan(LASER, Math.toRadians(-135), Math.toRadians(0.5), 0.1, 30, 0.1, Floats.wrap(ranges),
        Floats.EMPTY);
  }

  private static PointCloud cloud(int count) {
    ByteBuffer points = ByteBuffer.allocate(count * 16).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < count; i++) {
      double turn = i * 0.0137;
      double height = (i % 977) / 977.0 * 2.4;
      double radius = 2.6 + 0.5 * Math.sin(3 * turn) + 0.2 * Math.sin(height * 4);
      points.putFloat((float) (radius * Math.cos(turn))).putFloat((float) (radius * Math.sin(turn)))
          .putFloat((float) height)
          .putFloat((float) (height * 40));
    }
    List<PointField> fields = List.of(field("x", 0), field("y", 4), field("z", 8), field("intensity", 12));
    return new PointCloud(MAP, count, 1, fields, 16, 16 * count, ByteOrder.LITTLE_ENDIAN, true,
        Bytes.wrap(points.array(), 0, count * 16));
  }

  private static PointField field(String name, int offset) {
    return new PointField(name, offset, PointField.Format.FLOAT32, 1);
  }
}
