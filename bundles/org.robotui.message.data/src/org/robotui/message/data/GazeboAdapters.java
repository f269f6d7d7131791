package org.robotui.message.data;

import java.nio.ByteOrder;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.Data;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.geometry.Wrench;
import org.robotui.data.image.CameraInfo;
import org.robotui.data.image.RawImage;
import org.robotui.data.joint.JointState;
import org.robotui.data.marker.MarkerSet;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.message.ros.sensor_msgs.Image;
import org.robotui.message.ros.sensor_msgs.NavSatFix;
import org.robotui.message.ros.sensor_msgs.NavSatStatus;
import org.robotui.message.ros.std_msgs.Header;

/** The messages of Gazebo, which are read by the names of their fields. */
final class GazeboAdapters {
  /** How names of types begin, in newer releases and in older ones. */
  static final List<String> PACKAGES = List.of("gz.msgs.", "ignition.msgs.");

  private static final int COVARIANCE = 9;
  /** Names of ROS for what the formats are called. */
  private static final Map<String, String> PIXELS = Map.ofEntries(Map.entry("L_INT8", "mono8"),
      Map.entry("L_INT16", "mono16"), Map.entry("RGB_INT8", "rgb8"), Map.entry("RGBA_INT8", "rgba8"),
      Map.entry("BGRA_INT8", "bgra8"), Map.entry("RGB_INT16", "rgb16"), Map.entry("BGR_INT8", "bgr8"),
      Map.entry("BGR_INT16", "bgr16"), Map.entry("R_FLOAT32", "32FC1"), Map.entry("RGB_FLOAT32", "32FC3"),
      Map.entry("BAYER_RGGB8", "bayer_rggb8"), Map.entry("BAYER_BGGR8", "bayer_bggr8"),
      Map.entry("BAYER_GBRG8", "bayer_gbrg8"), Map.entry("BAYER_GRBG8", "bayer_grbg8"));
  private static final List<String> MODELS = List.of("PLUMB_BOB", "RATIONAL_POLYNOMIAL", "EQUIDISTANT");

  private GazeboAdapters() {}

  /** By their names without what these begin with. */
  static List<Adapter<?, ?>> all() {
    return List.of(
        of("LaserScan", LaserScan.class, GazeboAdapters::scan),
        of("Image", RawImage.class, GazeboAdapters::image),
        of("CameraInfo", CameraInfo.class, GazeboAdapters::calibration),
        of("PointCloudPacked", PointCloud.class, GazeboClouds::cloud),
        of("IMU", Imu.class, GazeboAdapters::imu),
        of("Odometry", Odometry.class, GazeboAdapters::odometry),
        of("Pose", StampedPose.class, (m, names) -> new StampedPose(frame(m, names), FoxgloveSpace.pose(m))),
        of("Twist", VelocityCommand.class,
            (m, names) -> new VelocityCommand(vector(m.inner("linear")), vector(m.inner("angular")))),
        of("Wrench", Wrench.class,
            (m, names) -> new Wrench(frame(m, names), vector(m.inner("force")), vector(m.inner("torque")))),
        of("Contacts", MarkerSet.class, GazeboContacts::markers),
        of("Model", JointState.class, (m, names) -> joints(m)),
        of("NavSat", GpsFix.class, GazeboAdapters::fix),
        of("BatteryState", Battery.class, (m, names) -> battery(m)));
  }

  private static <D extends Data> Adapter<DynamicRecord, D> of(String type, Class<D> data,
      Adapter.Simple<NamedFields, D> convert) {
    return new Adapter<>(type, new MessageForm.ByFields(), data,
        (m, names) -> Optional.of(convert.apply(new NamedFields(m), names)), m -> stamp(new NamedFields(m)));
  }

  static long stamp(NamedFields m) {
    return m.inner("header").nanos("stamp");
  }

  /** What is said beside the time, such as {@code frame_id}; empty where it is not. */
  static String said(NamedFields m, String key) {
    return m.inner("header").each("data").stream().filter(each -> each.text("key").equals(key))
        .flatMap(each -> each.texts("value").stream()).findFirst().orElse("");
  }

  static org.robotui.data.FrameId frame(NamedFields m, FrameNames names) {
    return names.frame(said(m, "frame_id"));
  }

  private static org.robotui.geometry.Vector3 vector(NamedFields m) {
    return Geometry.vector(FoxgloveTransforms.vector(m));
  }

  /** Of a scanner with several rows, the one in the middle. */
  private static LaserScan scan(NamedFields m, FrameNames names) {
    int rows = Math.max(1, m.size("vertical_count"));
    int count = m.numbers("ranges").size() / rows;
    Floats intensities = row(m.floats("intensities"), rows, count);
    String frame = m.text("frame");
    return new LaserScan(frame.isEmpty() ? frame(m, names) : names.frame(frame), m.number("angle_min"),
        m.number("angle_step"), m.number("range_min"), m.number("range_max"), 0,
        row(m.floats("ranges"), rows, count), intensities);
  }

  private static Floats row(Floats all, int rows, int count) {
    if (all.size() < rows * count || rows == 1) {
      return all.size() < rows * count ? Floats.EMPTY : all;
    }
    float[] row = new float[count];
    for (int i = 0; i < count; i++) {
      row[i] = all.get(rows / 2 * count + i);
    }
    return Floats.wrap(row);
  }

  private static RawImage image(NamedFields m, FrameNames names) {
    String format = m.text("pixel_format_type");
    return SensorAdapters.image(new Image(new Header(0, stamp(m), said(m, "frame_id")), m.size("height"),
        m.size("width"), PIXELS.getOrDefault(format, format), 0, m.size("step"),
        m.bytes("data").buffer(ByteOrder.LITTLE_ENDIAN)), names);
  }

  private static CameraInfo calibration(NamedFields m, FrameNames names) {
    NamedFields distortion = m.inner("distortion");
    return new CameraInfo(frame(m, names), m.size("width"), m.size("height"),
        MODELS.get(distortion.choice("model", MODELS)).toLowerCase(java.util.Locale.ROOT), distortion.numbers("k"),
        m.inner("intrinsics").numbers("k"), m.numbers("rectification_matrix"), m.inner("projection").numbers("p"));
  }

  private static Imu imu(NamedFields m, FrameNames names) {
    return new Imu(frame(m, names),
        present(m, "orientation").map(q -> Geometry.rotation(FoxgloveTransforms.rotation(q))),
        present(m, "angular_velocity").map(GazeboAdapters::vector),
        present(m, "linear_acceleration").map(GazeboAdapters::vector));
  }

  private static Optional<NamedFields> present(NamedFields m, String name) {
    return m.record().field(name).map(value -> m.inner(name));
  }

  private static Odometry odometry(NamedFields m, FrameNames names) {
    NamedFields twist = m.inner("twist");
    return new Odometry(frame(m, names), names.frame(said(m, "child_frame_id")), FoxgloveSpace.pose(m.inner("pose")),
        Doubles.EMPTY, vector(twist.inner("linear")), vector(twist.inner("angular")), Doubles.EMPTY);
  }

  private static JointState joints(NamedFields m) {
    return new JointState(m.each("joint").stream().map(joint -> {
      NamedFields axis = joint.inner("axis1");
      return new JointState.Joint(joint.text("name"), axis.number("position"), axis.number("velocity"),
          axis.number("force"));
    }).toList());
  }

  private static GpsFix fix(NamedFields m, FrameNames names) {
    String frame = m.text("frame_id");
    return SensorAdapters.fix(new NavSatFix(new Header(0, stamp(m), frame.isEmpty() ? said(m, "frame_id") : frame),
        new NavSatStatus(NavSatStatus.STATUS_FIX, 0), m.number("latitude_deg"), m.number("longitude_deg"),
        m.number("altitude"), new double[COVARIANCE], 0), names);
  }

  private static Battery battery(NamedFields m) {
    double percent = m.number("percentage", Double.NaN);
    Battery.Status status = switch (m.text("power_supply_status")) {
      case "CHARGING" -> Battery.Status.CHARGING;
      case "DISCHARGING" -> Battery.Status.DISCHARGING;
      case "NOT_CHARGING" -> Battery.Status.NOT_CHARGING;
      case "FULL" -> Battery.Status.FULL;
      default -> Battery.Status.UNKNOWN;
    };
    return new Battery(m.number("voltage"), m.number("current"),
        percent >= 0 && percent <= 100 ? percent / 100 : Double.NaN, status);
  }
}
