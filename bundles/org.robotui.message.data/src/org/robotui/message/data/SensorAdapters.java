package org.robotui.message.data;

import java.util.List;
import java.util.Optional;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.image.CameraInfo;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.message.ros.sensor_msgs.Image;
import org.robotui.message.ros.sensor_msgs.NavSatFix;
import org.robotui.message.ros.sensor_msgs.NavSatStatus;
import org.robotui.message.ros.sensor_msgs.Range;

/** Sensors. */
final class SensorAdapters {
  private static final double NO_MEASUREMENT = -1;

  private SensorAdapters() {}

  static List<Adapter<?, ?>> all() {
    return List.of(
        Adapter.of(org.robotui.message.ros.sensor_msgs.LaserScan.class, LaserScan.class,
            SensorAdapters::scan, m -> m.header().stamp()),
        Adapter.of(Range.class, RangeReadings.class, SensorAdapters::range, m -> m.header().stamp()),
        Adapter.of(Image.class, RawImage.class, SensorAdapters::image, m -> m.header().stamp()),
        Adapter.of(org.robotui.message.ros.sensor_msgs.CompressedImage.class, CompressedImage.class,
            SensorAdapters::compressed, m -> m.header().stamp()),
        Adapter.of(org.robotui.message.ros.sensor_msgs.CameraInfo.class, CameraInfo.class,
            SensorAdapters::cameraInfo, m -> m.header().stamp()),
        Adapter.of(org.robotui.message.ros.sensor_msgs.Imu.class, Imu.class, SensorAdapters::imu,
            m -> m.header().stamp()),
        Adapter.of(NavSatFix.class, GpsFix.class, SensorAdapters::fix, m -> m.header().stamp()));
  }

  private static LaserScan scan(org.robotui.message.ros.sensor_msgs.LaserScan m, FrameNames names) {
    Floats intensities = m.intensities().length == m.ranges().length ? Floats.wrap(m.intensities()) : Floats.EMPTY;
    return new LaserScan(names.frame(m.header().frameId()), m.angleMin(), m.angleIncrement(), m.rangeMin(),
        m.rangeMax(),
        Math.max(0, m.scanTime()), Floats.wrap(m.ranges()), intensities);
  }

  private static RangeReadings range(Range m, FrameNames names) {
    RangeReading.Kind kind = m.radiationType() == 0 ? RangeReading.Kind.ULTRASOUND : RangeReading.Kind.INFRARED;
    return new RangeReadings(List.of(new RangeReading(
        names.frame(m.header().frameId()), kind, m.fieldOfView(), m.minRange(), m.maxRange(), m.range())));
  }

  static RawImage image(Image m, FrameNames names) {
    PixelEncoding encoding = PixelEncoding.fromRos(m.encoding()).orElseThrow(
        () -> new IllegalArgumentException("encoding: '" + m.encoding() + "' is none that can be shown"));
    return new RawImage(names.frame(m.header().frameId()), Sizes.of("width", m.width()), Sizes.of("height", m.height()),
        encoding, m.isBigendian() != 0, Sizes.of("step", m.step()), Bytes.wrap(m.data()));
  }

  private static CompressedImage compressed(org.robotui.message.ros.sensor_msgs.CompressedImage m, FrameNames names) {
    return new CompressedImage(names.frame(m.header().frameId()), m.format(), Bytes.wrap(m.data()));
  }

  private static CameraInfo cameraInfo(org.robotui.message.ros.sensor_msgs.CameraInfo m, FrameNames names) {
    return new CameraInfo(names.frame(m.header().frameId()), Sizes.of("width", m.width()),
        Sizes.of("height", m.height()),
        m.distortionModel(), Doubles.wrap(m.d()), Doubles.wrap(m.k()), Doubles.wrap(m.r()), Doubles.wrap(m.p()));
  }

  /** By the convention of the message, a first covariance of -1 says that the part is not measured. */
  private static Imu imu(org.robotui.message.ros.sensor_msgs.Imu m, FrameNames names) {
    return new Imu(names.frame(m.header().frameId()),
        measured(m.orientationCovariance()).map(c -> Geometry.rotation(m.orientation())),
        measured(m.angularVelocityCovariance()).map(c -> Geometry.vector(m.angularVelocity())),
        measured(m.linearAccelerationCovariance()).map(c -> Geometry.vector(m.linearAcceleration())));
  }

  private static Optional<double[]> measured(double[] covariance) {
    return covariance[0] == NO_MEASUREMENT ? Optional.empty() : Optional.of(covariance);
  }

  static GpsFix fix(NavSatFix m, FrameNames names) {
    GpsFix.Quality quality = switch (m.status().status()) {
      case NavSatStatus.STATUS_FIX -> GpsFix.Quality.FIX;
      case NavSatStatus.STATUS_SBAS_FIX -> GpsFix.Quality.SATELLITE_AUGMENTED;
      case NavSatStatus.STATUS_GBAS_FIX -> GpsFix.Quality.GROUND_AUGMENTED;
      default -> GpsFix.Quality.NO_FIX;
    };
    double variance =
        m.positionCovarianceType() == 0 ? Double.NaN : Math.max(m.positionCovariance()[0], m.positionCovariance()[4]);
    return new GpsFix(names.frame(m.header().frameId()), quality, Math.toRadians(m.latitude()),
        Math.toRadians(m.longitude()), m.altitude(), Math.sqrt(variance));
  }
}
