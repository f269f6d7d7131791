package org.robotui.rfic.player.internal.convert;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.Vector3;
import org.robotui.player.interfaces.Angles;
import org.robotui.player.interfaces.Gps;
import org.robotui.player.interfaces.Pointcloud3d;

/** Inertial units, satellite receivers, points in space. */
public final class Sensing {
  private static final double DEGREES = 1e-7;
  private static final double MILLIMETRES = 1e-3;
  private static final int NO_FIX = 0;
  private static final int PLAIN_FIX = 1;
  private static final int POINT_BYTES = 16;
  private static final int COLOR_AT = 12;

  private static final List<PointField> FIELDS = List.of(
      new PointField("x", 0, PointField.Format.FLOAT32, 1),
      new PointField("y", 4, PointField.Format.FLOAT32, 1),
      new PointField("z", 8, PointField.Format.FLOAT32, 1),
      new PointField("rgb", COLOR_AT, PointField.Format.UINT32, 1));

  private Sensing() {}

  public static Imu imu(org.robotui.player.interfaces.Imu.State m, FrameId frame) {
    return new Imu(frame, Optional.of(Poses.of(m.pose()).rotation()), Optional.empty(), Optional.empty());
  }

  public static Imu imu(org.robotui.player.interfaces.Imu.Calibrated m, FrameId frame) {
    return measured(m, Optional.empty(), frame);
  }

  public static Imu imu(org.robotui.player.interfaces.Imu.Quaternion m, FrameId frame) {
    return measured(m.measured(), Optional.of(unit(new Quaternion(m.x(), m.y(), m.z(), m.w()))), frame);
  }

  public static Imu imu(org.robotui.player.interfaces.Imu.Euler m, FrameId frame) {
    Angles a = m.orientation();
    Vector3 angles = Poses.finite(new Vector3(a.roll(), a.pitch(), a.yaw()), "orientation");
    return measured(m.measured(), Optional.of(Quaternion.fromRollPitchYaw(angles.x(), angles.y(), angles.z())), frame);
  }

  public static Imu imu(org.robotui.player.interfaces.Imu.FullState m, FrameId frame) {
    return new Imu(frame, Optional.of(Poses.of(m.pose()).rotation()),
        Optional.of(Poses.finite(Poses.angles(m.velocity()), "velocity")),
        Optional.of(Poses.finite(Poses.position(m.acceleration()), "acceleration")));
  }

  private static Imu measured(org.robotui.player.interfaces.Imu.Calibrated m, Optional<Quaternion> orientation,
      FrameId frame) {
    return new Imu(frame, orientation,
        Optional.of(Poses.finite(new Vector3(m.gyroX(), m.gyroY(), m.gyroZ()), "gyro")),
        Optional
            .of(Poses.finite(new Vector3(m.accelerationX(), m.accelerationY(), m.accelerationZ()), "acceleration")));
  }

  private static Quaternion unit(Quaternion q) {
    try {
      return q.normalized();
    } catch (ArithmeticException e) {
      throw new IllegalArgumentException("orientation: " + e.getMessage(), e);
    }
  }

  public static GpsFix fix(Gps.State m, FrameId frame) {
    GpsFix.Quality quality = switch ((int) Math.min(m.quality(), Integer.MAX_VALUE)) {
      case NO_FIX -> GpsFix.Quality.NO_FIX;
      case PLAIN_FIX -> GpsFix.Quality.FIX;
      default -> GpsFix.Quality.GROUND_AUGMENTED;
    };
    double accuracy = m.horizontalError() > 0 ? m.horizontalError() : Double.NaN;
    return new GpsFix(frame, quality, Math.toRadians(m.latitude() * DEGREES), Math.toRadians(m.longitude() * DEGREES),
        m.altitude() * MILLIMETRES, accuracy);
  }

  public static PointCloud cloud(Pointcloud3d.Cloud m, FrameId frame) {
    int size = m.points().size();
    ByteBuffer points = ByteBuffer.allocate(size * POINT_BYTES).order(ByteOrder.LITTLE_ENDIAN);
    boolean dense = true;
    for (Pointcloud3d.Dot dot : m.points()) {
      float x = (float) dot.point().x();
      float y = (float) dot.point().y();
      float z = (float) dot.point().z();
      dense &= Float.isFinite(x) && Float.isFinite(y) && Float.isFinite(z);
      int color = (dot.color().red() & 0xff) << 16 | (dot.color().green() & 0xff) << 8 | dot.color().blue() & 0xff;
      points.putFloat(x).putFloat(y).putFloat(z).putInt(color);
    }
    return new PointCloud(frame, size, 1, FIELDS, POINT_BYTES, size * POINT_BYTES, ByteOrder.LITTLE_ENDIAN, dense,
        Bytes.wrap(points.flip()));
  }
}
