package org.robotui.rfic.lcm.internal.convert;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.data.array.Floats;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.geometry.Wrench;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.rfic.lcm.internal.language.Field;
import org.robotui.rfic.lcm.internal.language.Form;
import org.robotui.rfic.lcm.internal.language.Quantity;
import org.robotui.rfic.lcm.internal.language.Values;

/** What sensors say. */
final class SensorShapes {
  /** Where neither message nor configuration says how far a sensor sees. */
  private static final double FAR = 100;
  private static final double FIELD_OF_VIEW = Math.toRadians(30);

  private SensorShapes() {}

  static Stream<Shape<?>> all() {
    return Stream.of(
        new Shape<>(Form.of("laserscan", List.of("ranges", "angle_min", "angle_increment | angle_max"), List.of(
            Field.numbers("ranges", Quantity.LENGTH, "ranges"),
            Field.numbers("intensities", Quantity.PLAIN, "intensities"),
            Field.number("angle_min", Quantity.ANGLE, "angle_min", "rad0"),
            Field.number("angle_max", Quantity.ANGLE, "angle_max"),
            Field.number("angle_increment", Quantity.ANGLE, "angle_increment", "radstep"),
            Field.number("range_min", Quantity.LENGTH, "range_min"),
            Field.number("range_max", Quantity.LENGTH, "range_max"),
            Field.number("scan_time", Quantity.TIME, "scan_time"),
            Field.number("no_echo", Quantity.LENGTH), Field.text("frame", "frame"), Field.stamp())), LaserScan.class,
            SensorShapes::scan),
        new Shape<>(Form.of("ranges", List.of("ranges"), MotionShapes.fields(Stream.of(
            Field.numbers("ranges", Quantity.LENGTH, "ranges", "range"), Field.texts("names", "names"),
            Field.text("kind"),
            Field.number("field_of_view", Quantity.ANGLE, "field_of_view"),
            Field.number("range_min", Quantity.LENGTH, "range_min"),
            Field.number("range_max", Quantity.LENGTH, "range_max"), Field.number("no_echo", Quantity.LENGTH),
            Field.text("frame", "frame"),
            Field.stamp()), Poses.fields())), RangeReadings.class, SensorShapes::ranges),
        new Shape<>(
            Form.of("imu", List.of("orientation | yaw | roll | angular | wz | acceleration"), MotionShapes.fields(
                Poses.fields().filter(f -> f.group().equals("orientation")),
                MotionShapes.velocities().filter(f -> f.group().equals("angular")),
                Stream.of(Field.numbers("acceleration", Quantity.ACCELERATION, "acceleration", "accel"),
                    Field.text("frame", "frame"), Field.stamp()))),
            Imu.class, SensorShapes::imu),
        new Shape<>(Form.of("gps", List.of("latitude", "longitude"), List.of(
            Field.number("latitude", Quantity.ANGLE, "latitude deg", "lat deg"),
            Field.number("longitude", Quantity.ANGLE, "longitude deg", "lon deg"),
            Field.number("altitude", Quantity.LENGTH, "altitude", "elev", "alt"),
            Field.number("accuracy", Quantity.LENGTH, "accuracy"),
            Field.flag("fix"), Field.text("frame", "frame"), Field.stamp())), GpsFix.class, SensorShapes::gps),
        new Shape<>(
            Form.of("wrench", List.of("force | torque"), List.of(Field.numbers("force", Quantity.FORCE, "force"),
                Field.numbers("torque", Quantity.TORQUE, "torque"), Field.text("frame", "frame"), Field.stamp())),
            Wrench.class,
            (v, r) -> new Wrench(r.frame(v.text("frame", "base")), Poses.vector(v, "force", "", "", ""),
                Poses.vector(v, "torque", "", "", ""))));
  }

  private static LaserScan scan(Values v, Reception r) {
    float[] ranges = echoes(v, "ranges");
    double first = v.number("angle_min", 0);
    double step = v.has("angle_increment") ? v.number("angle_increment", 0)
        : ranges.length < 2 ? 0 : (v.number("angle_max", first) - first) / (ranges.length - 1);
    float[] intensities = floats(v.numbers("intensities"));
    return new LaserScan(r.frame(v.text("frame", "laser")), first, step, v.number("range_min", 0),
        v.number("range_max", FAR),
        v.number("scan_time", 0), Floats.wrap(ranges),
        intensities.length == ranges.length ? Floats.wrap(intensities) : Floats.EMPTY);
  }

  /** Distances, with what stands for "nothing there" as infinite. */
  private static float[] echoes(Values v, String field) {
    float[] ranges = floats(v.numbers(field));
    if (v.has("no_echo")) {
      float none = (float) v.number("no_echo", 0);
      for (int i = 0; i < ranges.length; i++) {
        ranges[i] = ranges[i] == none ? Float.POSITIVE_INFINITY : ranges[i];
      }
    }
    return ranges;
  }

  private static float[] floats(double[] numbers) {
    float[] floats = new float[numbers.length];
    for (int i = 0; i < floats.length; i++) {
      floats[i] = (float) numbers[i];
    }
    return floats;
  }

  /** Each sensor has a frame of its own, which is told where the message says where the sensors are. */
  private static RangeReadings ranges(Values v, Reception r) {
    float[] ranges = echoes(v, "ranges");
    List<String> names = v.texts("names");
    String mount = v.text("frame", "base");
    RangeReading.Kind kind = kind(v.text("kind", "ultrasound"));
    List<RangeReading> readings = new ArrayList<>(ranges.length);
    for (int i = 0; i < ranges.length; i++) {
      String name = names.size() == ranges.length ? names.get(i) : r.channel().toLowerCase(Locale.ROOT) + "_" + i;
      readings
          .add(new RangeReading(r.frame(name), kind, v.number("field_of_view", FIELD_OF_VIEW), v.number("range_min", 0),
              v.number("range_max", FAR), ranges[i]));
    }
    if (!readings.isEmpty() && (v.has("position") || v.has("x") || v.has("yaw"))) {
      List<RigidTransform> places = Poses.all(v, ranges.length);
      List<FrameTransform> transforms = new ArrayList<>(ranges.length);
      for (int i = 0; i < ranges.length; i++) {
        transforms.add(new FrameTransform(r.frame(mount), readings.get(i).frame(), r.stamp(), places.get(i), true));
      }
      r.transforms().accept(new TransformSet(transforms));
    }
    return new RangeReadings(readings);
  }

  private static RangeReading.Kind kind(String word) {
    return switch (word) {
      case "ultrasound", "sonar" -> RangeReading.Kind.ULTRASOUND;
      case "infrared" -> RangeReading.Kind.INFRARED;
      default -> throw new IllegalArgumentException(
          "'" + word + "' is no kind of sensor; write ultrasound or infrared");
    };
  }

  private static Imu imu(Values v, Reception r) {
    Optional<Quaternion> orientation = v.has("orientation") || v.has("roll") || v.has("pitch") || v.has("yaw")
        ? Optional.of(Poses.one(v).rotation())
        : Optional.empty();
    Optional<Vector3> angular = v.has("angular") || v.has("wx") || v.has("wy") || v.has("wz")
        ? Optional.of(Poses.vector(v, "angular", "wx", "wy", "wz"))
        : Optional.empty();
    Optional<Vector3> acceleration =
        v.has("acceleration") ? Optional.of(Poses.vector(v, "acceleration", "", "", "")) : Optional.empty();
    return new Imu(r.frame(v.text("frame", "imu")), orientation, angular, acceleration);
  }

  private static GpsFix gps(Values v, Reception r) {
    boolean fix = !v.has("fix") || v.flag("fix");
    return new GpsFix(r.frame(v.text("frame", "gps")), fix ? GpsFix.Quality.FIX : GpsFix.Quality.NO_FIX,
        fix ? v.number("latitude", 0) : Double.NaN, fix ? v.number("longitude", 0) : Double.NaN,
        v.number("altitude", Double.NaN), v.number("accuracy", Double.NaN));
  }
}
