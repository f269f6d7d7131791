package org.robotui.rfic.carmen.internal.convert;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.session.RobotFrames;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.data.FrameId;
import org.robotui.data.array.Floats;
import org.robotui.data.sensor.Bumper;
import org.robotui.data.sensor.Bumpers;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** What the robot's sensors say. */
public final class CarmenSensing {
  /** What sonars see at most, which their message does not tell. */
  private static final double SONAR_RANGE = 5;
  private static final int MOST = 1024;

  private CarmenSensing() {}

  /** Scanners say the farthest distance where a beam hit nothing. */
  public static LaserScan scan(IpcRecord m, FrameId frame) {
    IpcRecord config = m.record("config");
    double max = config.number("maximum_range");
    double farthest = max > 0 && Double.isFinite(max) ? max : Float.MAX_VALUE;
    float[] ranges = m.floats("range");
    for (int i = 0; i < ranges.length; i++) {
      ranges[i] = ranges[i] >= farthest * (1 - 1e-6) ? Float.POSITIVE_INFINITY : ranges[i];
    }
    float[] remission = m.floats("remission");
    return new LaserScan(frame, CarmenPlaces.finite(config, "start_angle"), step(config, ranges.length), 0, farthest, 0,
        Floats.wrap(ranges), remission.length == ranges.length ? Floats.wrap(remission) : Floats.EMPTY);
  }

  private static double step(IpcRecord config, int rays) {
    double told = config.number("angular_resolution");
    return Double.isFinite(told) && told != 0 || rays < 2 ? told
        : CarmenPlaces.finite(config, "fov") / (rays - 1);
  }

  /** Where a scanner is on the robot, from where both were when it measured. */
  public static RigidTransform mount(IpcRecord m) {
    return CarmenPlaces.pose(m.record("robot_pose")).inverse().times(CarmenPlaces.pose(m.record("laser_pose")));
  }

  public static RangeReadings sonars(IpcRecord m, RobotFrames frames) {
    double[] ranges = m.doubles("range");
    double cone = Math.clamp(CarmenPlaces.finite(m, "cone_angle"), 0, Math.PI);
    List<RangeReading> readings = new ArrayList<>();
    for (int i = 0; i < bounded(ranges.length); i++) {
      double range = ranges[i] >= SONAR_RANGE ? Double.POSITIVE_INFINITY : ranges[i];
      readings.add(new RangeReading(frames.device("sonar_" + i), RangeReading.Kind.ULTRASOUND, cone, 0, SONAR_RANGE,
          range));
    }
    return new RangeReadings(readings);
  }

  /** Where the sonars are on the robot, in their order. */
  public static List<RigidTransform> sonarMounts(IpcRecord m) {
    List<IpcRecord> offsets = m.records("sonar_offsets");
    return offsets.subList(0, bounded(offsets.size())).stream().map(CarmenPlaces::pose).toList();
  }

  /** A bumper lies where it is said to be, and is turned away from the middle; how long it is, is not said. */
  public static Bumpers bumpers(IpcRecord m, FrameId base) {
    byte[] state = m.octets("state");
    List<IpcRecord> offsets = m.records("bumper_offsets");
    List<Bumper> bumpers = new ArrayList<>();
    for (int i = 0; i < bounded(state.length); i++) {
      double x = i < offsets.size() ? CarmenPlaces.finite(offsets.get(i), "x") : 0;
      double y = i < offsets.size() ? CarmenPlaces.finite(offsets.get(i), "y") : 0;
      bumpers.add(new Bumper(RigidTransform.planar(x, y, Math.atan2(y, x)), 0, 0, state[i] != 0));
    }
    return new Bumpers(base, bumpers);
  }

  private static int bounded(int count) {
    if (count > MOST) {
      throw new IllegalArgumentException(count + " sensors are more than the " + MOST + " that a ring can have");
    }
    return count;
  }

  /** A quaternion that is none means that the unit does not tell how it is turned. */
  public static Imu imu(IpcRecord m, FrameId frame) {
    Quaternion turned = new Quaternion(m.number("q1"), m.number("q2"), m.number("q3"), m.number("q0"));
    double norm = Math.hypot(Math.hypot(turned.x(), turned.y()), Math.hypot(turned.z(), turned.w()));
    return new Imu(frame, Math.abs(norm - 1) < 0.1 ? Optional.of(turned.normalized()) : Optional.empty(),
        Optional.of(vector(m, "gyro_")), Optional.of(vector(m, "acc_")));
  }

  private static Vector3 vector(IpcRecord m, String of) {
    return new Vector3(CarmenPlaces.finite(m, of + "x"), CarmenPlaces.finite(m, of + "y"),
        CarmenPlaces.finite(m, of + "z"));
  }

  /** Degrees; the letters say on which half of the earth. */
  public static GpsFix fix(IpcRecord m, FrameId frame) {
    double latitude = Math.abs(CarmenPlaces.finite(m, "latitude")) * (m.whole("lat_orient") == 'S' ? -1 : 1);
    double longitude = Math.abs(CarmenPlaces.finite(m, "longitude")) * (m.whole("long_orient") == 'W' ? -1 : 1);
    GpsFix.Quality quality = switch (m.whole("gps_quality")) {
      case 0 -> GpsFix.Quality.NO_FIX;
      case 1 -> GpsFix.Quality.FIX;
      default -> GpsFix.Quality.GROUND_AUGMENTED;
    };
    return new GpsFix(frame, quality, Math.toRadians(latitude), Math.toRadians(longitude), m.number("sea_level"),
        Double.NaN);
  }
}
