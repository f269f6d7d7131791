package org.robotui.message.data;

import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.image.CameraInfo;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.RawImage;
import org.robotui.data.joint.JointState;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.geometry.Vector3;
import org.robotui.message.ros.sensor_msgs.Image;
import org.robotui.message.ros.sensor_msgs.NavSatFix;
import org.robotui.message.ros.sensor_msgs.NavSatStatus;
import org.robotui.message.ros.std_msgs.Header;

/** The schemas of Foxglove, which come in JSON, in Protocol Buffers and as messages of ROS. */
final class FoxgloveAdapters {
  /** How names begin in JSON and in Protocol Buffers. */
  static final String NAMES = "foxglove.";
  /** How they begin as messages of ROS. */
  static final String ROS_PACKAGE = "foxglove_msgs/";

  private static final List<String> LEVELS = List.of("UNKNOWN", "DEBUG", "INFO", "WARNING", "ERROR", "FATAL");
  private static final int COVARIANCE = 9;
  private static final List<String> COVARIANCES = List.of("UNKNOWN", "APPROXIMATED", "DIAGONAL_KNOWN", "KNOWN");

  private FoxgloveAdapters() {}

  /** By their names without what these begin with. */
  static List<Adapter<?, ?>> all() {
    return List.of(
        Adapter.ofFields("LaserScan", LaserScan.class, FoxgloveSpace::scan),
        Adapter.ofFields("PointCloud", PointCloud.class, FoxgloveSpace::cloud),
        Adapter.ofFields("Grid", GridMap.class, FoxgloveSpace::grid),
        Adapter.ofFields("Odometry", Odometry.class, FoxgloveAdapters::odometry),
        Adapter.ofFields("PoseInFrame", StampedPose.class,
            (m, names) -> new StampedPose(names.frame(m.text("frame_id")), FoxgloveSpace.pose(m.inner("pose")))),
        Adapter.ofFields("PosesInFrame", PoseArray.class, (m, names) -> new PoseArray(names.frame(m.text("frame_id")),
            m.each("poses").stream().map(FoxgloveSpace::pose).toList())),
        transforms("FrameTransform"),
        transforms("FrameTransforms"),
        Adapter.ofFields("CompressedImage", CompressedImage.class,
            (m, names) -> new CompressedImage(names.frame(m.text("frame_id")), m.text("format"), m.bytes("data"))),
        Adapter.ofFields("RawImage", RawImage.class, FoxgloveAdapters::image),
        Adapter.ofFields("CameraCalibration", CameraInfo.class, FoxgloveAdapters::calibration),
        Adapter.ofFields("LocationFix", GpsFix.class, FoxgloveAdapters::fix),
        Adapter.ofFields("JointStates", JointState.class, (m, names) -> joints(m)),
        Adapter.ofFields("Log", LogEntry.class, (m, names) -> log(m)));
  }

  private static Adapter<?, ?> transforms(String type) {
    return new Adapter<>(type, new MessageForm.ByFields(), TransformSet.class,
        (m, names) -> StateAdapters.transforms(FoxgloveTransforms.message(m), names, false), FoxgloveTransforms::nanos);
  }

  private static Header header(NamedFields m) {
    return new Header(0, m.nanos("timestamp"), m.text("frame_id"));
  }

  private static Odometry odometry(NamedFields m, FrameNames names) {
    return new Odometry(names.frame(m.text("frame_id")), names.frame(m.text("body_frame_id")),
        FoxgloveSpace.pose(m.inner("pose")), m.numbers("pose_covariance"), velocity(m, "linear_velocity"),
        velocity(m, "angular_velocity"), m.numbers("velocity_covariance"));
  }

  private static Vector3 velocity(NamedFields m, String name) {
    return Geometry.vector(FoxgloveTransforms.vector(m.inner(name)));
  }

  private static RawImage image(NamedFields m, FrameNames names) {
    return SensorAdapters.image(new Image(header(m), m.size("height"), m.size("width"), m.text("encoding"), 0,
        m.size("step"), m.bytes("data").buffer(ByteOrder.LITTLE_ENDIAN)), names);
  }

  private static CameraInfo calibration(NamedFields m, FrameNames names) {
    return new CameraInfo(names.frame(m.text("frame_id")), m.size("width"), m.size("height"),
        m.text("distortion_model"), m.numbers("D"), m.numbers("K"), m.numbers("R"), m.numbers("P"));
  }

  private static GpsFix fix(NamedFields m, FrameNames names) {
    double[] covariance = new double[m.numbers("position_covariance").size()];
    m.numbers("position_covariance").buffer().get(covariance);
    return SensorAdapters.fix(new NavSatFix(header(m), new NavSatStatus(NavSatStatus.STATUS_FIX, 0),
        m.number("latitude"), m.number("longitude"), m.number("altitude"), Arrays.copyOf(covariance, COVARIANCE),
        covariance.length < COVARIANCE ? 0 : m.choice("position_covariance_type", COVARIANCES)), names);
  }

  private static JointState joints(NamedFields m) {
    return new JointState(m.each("joints").stream().map(j -> new JointState.Joint(j.text("name"),
        j.number("position", Double.NaN), j.number("velocity", Double.NaN), j.number("effort", Double.NaN))).toList());
  }

  private static LogEntry log(NamedFields m) {
    Severity severity = switch (LEVELS.get(m.choice("level", LEVELS))) {
      case "DEBUG" -> Severity.DEBUG;
      case "WARNING" -> Severity.WARNING;
      case "ERROR" -> Severity.ERROR;
      case "FATAL" -> Severity.FATAL;
      default -> Severity.INFO;
    };
    String file = m.text("file");
    return new LogEntry(severity, m.text("name"), m.text("message"),
        file.isEmpty() ? "" : file + ":" + m.size("line"));
  }
}
