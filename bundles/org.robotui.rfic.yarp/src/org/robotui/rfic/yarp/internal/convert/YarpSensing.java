package org.robotui.rfic.yarp.internal.convert;

import java.io.IOException;
import java.util.Optional;
import org.robotui.api.session.RobotFrames;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.geometry.Wrench;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.YarpValue;
import org.robotui.yarp.image.YarpImage;

/**
 * What devices of YARP say. Angles are degrees there. What is not of the form is refused with an
 * {@link IllegalArgumentException} that says what was expected.
 */
public final class YarpSensing {
  private static final int SCAN_PARTS = 6;
  private static final int SENSOR_KINDS = 10;
  private static final int GYROSCOPES = 0;
  private static final int ACCELEROMETERS = 1;
  private static final int ORIENTATIONS = 3;
  private static final int FORCES = 5;
  private static final int WRENCH_NUMBERS = 6;
  private static final int ODOMETRY_NUMBERS = 9;
  private static final int PLACE_PARTS = 5;
  private static final int BATTERY_PARTS = 5;
  private static final double WHOLE = 100;

  private YarpSensing() {}

  /** Its beams lie one width apart, of which there are as many as beams. */
  public static LaserScan scan(Bottle m, FrameId frame) {
    double[] said = m.get(4).items().numbers();
    expect(m.size() == SCAN_PARTS && said.length > 0, "a scan: four numbers, a list of distances, a status", m);
    float[] ranges = new float[said.length];
    for (int i = 0; i < ranges.length; i++) {
      ranges[i] = (float) said[i];
    }
    double first = degrees(m, 0);
    double least = Math.max(0, finite(m, 2));
    return new LaserScan(frame, first, (degrees(m, 1) - first) / ranges.length, least, Math.max(least, finite(m, 3)), 0,
        Floats.wrap(ranges), Floats.EMPTY);
  }

  /** Of ten kinds of sensors the first gyroscope, accelerometer and orientation. */
  public static Imu imu(Bottle m, FrameId frame) {
    expect(m.size() == SENSOR_KINDS, "lists of ten kinds of sensors", m);
    Optional<Vector3> turning =
        first(m, GYROSCOPES).map(v -> new Vector3(Math.toRadians(v.x()), Math.toRadians(v.y()), Math.toRadians(v.z())));
    Optional<Vector3> accelerating = first(m, ACCELEROMETERS);
    Optional<Quaternion> turned = first(m, ORIENTATIONS).map(v -> Quaternion.fromRollPitchYaw(Math.toRadians(v.x()),
        Math.toRadians(v.y()), Math.toRadians(v.z())));
    if (turning.isEmpty() && accelerating.isEmpty() && turned.isEmpty()) {
      throw new IllegalArgumentException(
          "there is no gyroscope, accelerometer or orientation among its sensors; give it another type in 'types'");
    }
    return new Imu(frame, turned, turning, accelerating);
  }

  private static Optional<Vector3> first(Bottle m, int kind) {
    double[] numbers = m.get(kind).items().get(0).items().get(0).items().numbers();
    return numbers.length == 3 ? Optional.of(vector(numbers, 0)) : Optional.empty();
  }

  private static Vector3 vector(double[] numbers, int at) {
    Vector3 vector = new Vector3(numbers[at], numbers[at + 1], numbers[at + 2]);
    if (!vector.isFinite()) {
      throw new IllegalArgumentException("a sensor says " + vector);
    }
    return vector;
  }

  /** The first sensor of forces and torques. */
  public static Wrench wrench(Bottle m, FrameId frame) {
    double[] numbers = m.size() == WRENCH_NUMBERS ? m.numbers()
        : m.get(FORCES).items().get(0).items().get(0).items().numbers();
    expect(numbers.length == WRENCH_NUMBERS, "six numbers of a sensor of forces and torques", m);
    return new Wrench(frame, vector(numbers, 0), vector(numbers, 3));
  }

  public static Odometry odometry(Bottle m, RobotFrames frames) {
    expect(m.size() == ODOMETRY_NUMBERS, "nine numbers of odometry", m);
    return new Odometry(frames.odom(), frames.base(),
        RigidTransform.planar(finite(m, 0), finite(m, 1), degrees(m, 2)), Doubles.EMPTY,
        new Vector3(finite(m, 3), finite(m, 4), 0), new Vector3(0, 0, degrees(m, 5)), Doubles.EMPTY);
  }

  /** A place on a map: its name, x, y, an angle, a description. */
  public static PoseEstimate place(Bottle m, FrameId map) {
    expect(m.size() == PLACE_PARTS, "a place: the name of a map, three numbers, a text", m);
    return new PoseEstimate(map, RigidTransform.planar(finite(m, 1), finite(m, 2), degrees(m, 3)), Doubles.EMPTY);
  }

  public static Battery battery(Bottle m) {
    expect(m.size() == BATTERY_PARTS, "five numbers of a battery", m);
    double charge = m.get(2).number() / WHOLE;
    return new Battery(m.get(0).number(), m.get(1).number(),
        charge >= 0 && charge <= 1 ? charge : Double.NaN, switch ((int) m.get(4).number()) {
          case 0 -> Battery.Status.NOT_CHARGING;
          case 1 -> Battery.Status.CHARGING;
          case 2 -> Battery.Status.DISCHARGING;
          default -> Battery.Status.UNKNOWN;
        });
  }

  public static RawImage image(Bottle m, FrameId frame) {
    try {
      YarpImage image = YarpImage.read(m);
      PixelEncoding encoding = switch (image.pixels()) {
        case "mono" -> PixelEncoding.MONO8;
        case "mo16" -> PixelEncoding.MONO16;
        case "rgb" -> PixelEncoding.RGB8;
        case "bgr" -> PixelEncoding.BGR8;
        case "rgba" -> PixelEncoding.RGBA8;
        case "bgra" -> PixelEncoding.BGRA8;
        case "dec" -> PixelEncoding.F32C1;
        case "grbg" -> PixelEncoding.BAYER_GRBG8;
        case "bggr" -> PixelEncoding.BAYER_BGGR8;
        case "gbrg" -> PixelEncoding.BAYER_GBRG8;
        case "rggb" -> PixelEncoding.BAYER_RGGB8;
        default -> throw new IllegalArgumentException("pixels of the kind '" + image.pixels() + "' are not shown");
      };
      return new RawImage(frame, image.width(), image.height(), encoding, false, image.step(),
          Bytes.wrap(image.rows(), 0, image.rows().length));
    } catch (IOException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /** A bottle of one blob, as pictures by mjpeg are. */
  public static CompressedImage jpeg(Bottle m, FrameId frame) {
    if (m.get(0) instanceof YarpValue.Blob blob) {
      return new CompressedImage(frame, "jpeg", Bytes.wrap(blob.bytes(), 0, blob.bytes().length));
    }
    throw new IllegalArgumentException("what came is no JPEG file");
  }

  static double finite(Bottle m, int index) {
    double value = m.get(index).number();
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException("value " + (index + 1) + " is " + m.get(index) + ", which is no number");
    }
    return value;
  }

  static double degrees(Bottle m, int index) {
    return Math.toRadians(finite(m, index));
  }

  private static void expect(boolean holds, String what, Bottle m) {
    if (!holds) {
      throw new IllegalArgumentException(
          "what came is not " + what + ", but has " + m.size() + " parts; give the port another type in 'types'");
    }
  }
}
