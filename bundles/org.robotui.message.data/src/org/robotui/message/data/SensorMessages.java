package org.robotui.message.data;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Floats;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.RawImage;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.Vector3;
import org.robotui.message.data.DataMessages.Maker;
import org.robotui.message.ros.sensor_msgs.Image;
import org.robotui.message.ros.sensor_msgs.NavSatFix;
import org.robotui.message.ros.sensor_msgs.NavSatStatus;
import org.robotui.message.ros.sensor_msgs.PointCloud2;
import org.robotui.message.ros.sensor_msgs.PointField;
import org.robotui.message.ros.std_msgs.Header;

/** What sensors say, as messages. */
final class SensorMessages {
  private static final int SPACE = 9;
  private static final double NO_MEASUREMENT = -1;

  private SensorMessages() {}

  static List<Maker<?, ?>> all() {
    return List.of(
        Maker.of(LaserScan.class, org.robotui.message.ros.sensor_msgs.LaserScan.class, SensorMessages::scan),
        Maker.of(RawImage.class, Image.class, SensorMessages::image),
        Maker.of(CompressedImage.class, org.robotui.message.ros.sensor_msgs.CompressedImage.class,
            (i, at) -> new org.robotui.message.ros.sensor_msgs.CompressedImage(header(i.frame(), at), i.format(),
                bytes(i.data()))),
        Maker.of(PointCloud.class, PointCloud2.class, SensorMessages::cloud),
        Maker.of(Imu.class, org.robotui.message.ros.sensor_msgs.Imu.class, SensorMessages::imu),
        Maker.of(GpsFix.class, NavSatFix.class, SensorMessages::fix));
  }

  static Header header(FrameId frame, long stampNanos) {
    return new Header(0, stampNanos, frame.name());
  }

  static ByteBuffer bytes(Bytes bytes) {
    return bytes.buffer(ByteOrder.LITTLE_ENDIAN);
  }

  private static org.robotui.message.ros.sensor_msgs.LaserScan scan(LaserScan s, long at) {
    double last = s.angle(Math.max(0, s.ranges().size() - 1));
    return new org.robotui.message.ros.sensor_msgs.LaserScan(header(s.frame(), at), (float) s.angleMin(), (float) last,
        (float) s.angleIncrement(), 0, (float) s.scanTime(), (float) s.rangeMin(), (float) s.rangeMax(),
        floats(s.ranges()), floats(s.intensities()));
  }

  private static float[] floats(Floats floats) {
    float[] values = new float[floats.size()];
    floats.buffer().get(values);
    return values;
  }

  private static Image image(RawImage i, long at) {
    return new Image(header(i.frame(), at), i.height(), i.width(), i.encoding().rosName(), i.bigEndian() ? 1 : 0,
        i.step(), bytes(i.pixels()));
  }

  private static PointCloud2 cloud(PointCloud c, long at) {
    List<PointField> fields = c.fields().stream()
        .map(f -> new PointField(f.name(), f.offset(), f.format().ordinal() + 1, f.count())).toList();
    return new PointCloud2(header(c.frame(), at), c.height(), c.width(), fields,
        c.order().equals(ByteOrder.BIG_ENDIAN), c.pointStep(), c.rowStep(), bytes(c.points()), c.dense());
  }

  /** What is not measured has a first covariance of -1, by the convention of the message. */
  private static org.robotui.message.ros.sensor_msgs.Imu imu(Imu i, long at) {
    return new org.robotui.message.ros.sensor_msgs.Imu(header(i.frame(), at),
        Geometry.pose(new org.robotui.geometry.RigidTransform(Vector3.ZERO,
            i.orientation().orElse(Quaternion.IDENTITY))).orientation(),
        covariance(i.orientation()), Geometry.vector(i.angularVelocity().orElse(Vector3.ZERO)),
        covariance(i.angularVelocity()), Geometry.vector(i.linearAcceleration().orElse(Vector3.ZERO)),
        covariance(i.linearAcceleration()));
  }

  private static double[] covariance(Optional<?> measured) {
    double[] covariance = new double[SPACE];
    covariance[0] = measured.isPresent() ? 0 : NO_MEASUREMENT;
    return covariance;
  }

  private static NavSatFix fix(GpsFix f, long at) {
    int status = switch (f.quality()) {
      case NO_FIX -> NavSatStatus.STATUS_NO_FIX;
      case FIX -> NavSatStatus.STATUS_FIX;
      case SATELLITE_AUGMENTED -> NavSatStatus.STATUS_SBAS_FIX;
      case GROUND_AUGMENTED -> NavSatStatus.STATUS_GBAS_FIX;
    };
    boolean known = Double.isFinite(f.horizontalAccuracy());
    double variance = known ? f.horizontalAccuracy() * f.horizontalAccuracy() : 0;
    return new NavSatFix(header(f.frame(), at), new NavSatStatus(status, NavSatStatus.SERVICE_GPS),
        Math.toDegrees(f.latitude()), Math.toDegrees(f.longitude()), f.altitude(),
        new double[]{variance, 0, 0, 0, variance, 0, 0, 0, variance},
        known ? NavSatFix.COVARIANCE_TYPE_APPROXIMATED : NavSatFix.COVARIANCE_TYPE_UNKNOWN);
  }
}
