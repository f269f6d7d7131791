package org.robotui.message.data;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.image.CameraInfo;
import org.robotui.data.image.RawImage;
import org.robotui.data.joint.JointState;
import org.robotui.data.marker.Marker;
import org.robotui.data.marker.MarkerSet;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.geometry.Vector3;

class GazeboAdaptersTest {
  private static final FrameNames NAMES = new FrameNames("robby", ClockKind.ROBOT);

  private final Adapters adapters = new Adapters();

  @SuppressWarnings("unchecked") // all of these adapters read records
  private Adapter<DynamicRecord, ?> adapter(String type) {
    return (Adapter<DynamicRecord, ?>) adapters.ofFields(type);
  }

  private <D extends Data> D converted(String type, Class<D> data, DynamicRecord record) {
    return data.cast(adapter("gz.msgs." + type).convert().apply(record, NAMES).orElseThrow());
  }

  /** What stands before a message: a time, and a frame among words by their keys. */
  private static NamedRecord header(String... keysAndWords) {
    List<NamedRecord> words = new ArrayList<>();
    for (int i = 0; i < keysAndWords.length; i += 2) {
      words.add(NamedRecord.of("key", keysAndWords[i], "value", List.of(keysAndWords[i + 1])));
    }
    return NamedRecord.of("stamp", NamedRecord.of("sec", 7, "nsec", 9), "data", words);
  }

  private static NamedRecord vector(double x, double y, double z) {
    return NamedRecord.of("x", x, "y", y, "z", z);
  }

  @Test
  void theOlderNamesOfTypesMeanTheSame() {
    NamedRecord twist = NamedRecord.of("linear", vector(1, 2, 3), "angular", vector(0, 0, 4));
    VelocityCommand newer = converted("Twist", VelocityCommand.class, twist);
    assertEquals(new Vector3(1, 2, 3), newer.linear());
    assertEquals(4, newer.angular().z());
    assertEquals(Optional.of(newer), adapter("ignition.msgs.Twist").convert().apply(twist, NAMES));
  }

  @Test
  void contactsArePointsAndNormalsInTheWorldThatGoByThemselves() {
    NamedRecord one = NamedRecord.of("world", NamedRecord.of("name", "yard"), "position",
        List.of(vector(1, 2, 0), vector(1, 3, 0)), "normal", List.of(vector(0, 0, 1)));
    MarkerSet set = converted("Contacts", MarkerSet.class, NamedRecord.of("contact", List.of(one)));
    assertTrue(set.all(), "what touched before touches no more");
    List<Marker> markers = set.entries().stream().map(entry -> entry.marker().orElseThrow()).toList();
    assertEquals(List.of(Marker.Type.SPHERE_LIST, Marker.Type.LINE_LIST), markers.stream().map(Marker::type).toList());
    assertEquals(Floats.of(1, 2, 0, 1, 3, 0), markers.getFirst().points());
    assertEquals(Floats.of(1, 2, 0, 1, 2, 0.15f), markers.getLast().points());
    markers.forEach(marker -> {
      assertEquals(new FrameId("robby", "yard"), marker.frame());
      assertTrue(marker.lifetimeNanos() > 0);
    });
    assertEquals(List.of(), converted("Contacts", MarkerSet.class, NamedRecord.of("contact", List.of())).entries());
  }

  @Test
  void theTimeIsThatOfTheHeader() {
    assertEquals(7_000_000_009L, GazeboAdapters.stamp(new NamedFields(NamedRecord.of("header", header()))));
  }

  @Test
  void aScanHasTheFrameThatItNamesItselfElseThatOfItsHeader() {
    NamedRecord scan = NamedRecord.of("header", header("seq", "3", "frame_id", "lidar"), "angle_min", -1, "angle_step",
        0.5, "range_min", 0.1, "range_max", 9, "ranges", new double[]{1, 2}, "intensities", new double[]{5, 6});
    LaserScan read = converted("LaserScan", LaserScan.class, scan);
    assertEquals(new FrameId("robby", "lidar"), read.frame());
    assertEquals(-0.5, read.angle(1), 1e-9);
    assertEquals(Floats.wrap(new float[]{5, 6}), read.intensities());
    assertEquals(new FrameId("robby", "front"),
        converted("LaserScan", LaserScan.class,
            NamedRecord.of("frame", "front", "range_max", 9, "ranges", new double[]{1})).frame());
  }

  @Test
  void ofSeveralRowsOfAScanItIsTheOneInTheMiddle() {
    LaserScan read = converted("LaserScan", LaserScan.class, NamedRecord.of("vertical_count", 3, "range_max", 9,
        "ranges", new double[]{1, 2, 3, 4, 5, 6}, "intensities", new double[]{1}));
    assertEquals(Floats.wrap(new float[]{3, 4}), read.ranges());
    assertEquals(Floats.EMPTY, read.intensities(), "too few for the ranges");
  }

  @Test
  void aScanThatClaimsMoreRowsThanItHasIsEmpty() {
    assertEquals(0, converted("LaserScan", LaserScan.class,
        NamedRecord.of("vertical_count", 2_000_000_000, "range_max", 9, "ranges", new double[]{1, 2})).ranges().size());
  }

  @ParameterizedTest
  @CsvSource({"RGB_INT8, RGB8, 3", "L_INT8, MONO8, 1", "R_FLOAT32, F32C1, 4", "BAYER_RGGB8, BAYER_RGGB8, 1"})
  void formatsOfPicturesAreKnown(String format, String encoding, int bytes) {
    RawImage image = converted("Image", RawImage.class, NamedRecord.of("header", header("frame_id", "camera"), "width",
        2, "height", 1, "step", 2 * bytes, "pixel_format_type", format, "data",
        Bytes.wrap(ByteBuffer.allocate(2 * bytes))));
    assertEquals(encoding, image.encoding().name());
    assertEquals(List.of(2, 1, 2 * bytes), List.of(image.width(), image.height(), image.step()));
    assertEquals(new FrameId("robby", "camera"), image.frame());
  }

  @Test
  void aPictureThatIsShorterThanItSaysIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> converted("Image", RawImage.class, NamedRecord.of("width", 100,
        "height", 100, "step", 300, "pixel_format_type", "RGB_INT8", "data", Bytes.of((byte) 1))));
  }

  @Test
  void aCalibrationHasItsModelByNameOrByNumber() {
    NamedRecord camera = NamedRecord.of("width", 4, "height", 2, "distortion",
        NamedRecord.of("model", 1, "k", new double[]{1, 2, 3, 4, 5, 6, 7, 8}), "intrinsics",
        NamedRecord.of("k", new double[]{1, 0, 2, 0, 1, 1, 0, 0, 1}), "projection",
        NamedRecord.of("p", new double[]{1, 0, 2, 0, 0, 1, 1, 0, 0, 0, 1, 0}), "rectification_matrix",
        new double[]{1, 0, 0, 0, 1, 0, 0, 0, 1});
    CameraInfo info = converted("CameraInfo", CameraInfo.class, camera);
    assertEquals("rational_polynomial", info.distortionModel());
    assertEquals(Doubles.of(1, 0, 2, 0, 1, 1, 0, 0, 1), info.intrinsics());
  }

  @Test
  void aCloudIsReadAsItIsPacked() {
    ByteBuffer points = ByteBuffer.allocate(24).order(ByteOrder.LITTLE_ENDIAN);
    points.putFloat(1).putFloat(2).putFloat(3).putFloat(4).putFloat(5).putFloat(6).flip();
    List<NamedRecord> fields = List.of(NamedRecord.of("name", "x", "offset", 0, "datatype", "FLOAT32", "count", 1),
        NamedRecord.of("name", "y", "offset", 4, "datatype", 6),
        NamedRecord.of("name", "z", "offset", 8, "datatype", 6));
    PointCloud cloud = converted("PointCloudPacked", PointCloud.class, NamedRecord.of("field", fields, "width", 2,
        "height", 1, "point_step", 12, "row_step", 24, "data", Bytes.wrap(points)));
    assertEquals(2, cloud.size());
    assertThrows(IllegalArgumentException.class, () -> converted("PointCloudPacked", PointCloud.class, NamedRecord.of(
        "field", fields, "width", 2_000_000, "height", 1, "point_step", 12, "row_step", 24, "data",
        Bytes.wrap(points))));
  }

  @Test
  void whatAnImuDoesNotMeasureIsAbsent() {
    Imu imu = converted("IMU", Imu.class, NamedRecord.of("angular_velocity", vector(0, 0, 1)));
    assertEquals(Optional.of(new Vector3(0, 0, 1)), imu.angularVelocity());
    assertTrue(imu.orientation().isEmpty() && imu.linearAcceleration().isEmpty());
  }

  @Test
  void odometrySaysBothItsFrames() {
    Odometry odometry = converted("Odometry", Odometry.class, NamedRecord.of("header",
        header("frame_id", "odom", "child_frame_id", "base"), "pose",
        NamedRecord.of("position", vector(1, 2, 0), "orientation", NamedRecord.of("w", 1)), "twist",
        NamedRecord.of("linear", vector(0.5, 0, 0))));
    assertEquals(new FrameId("robby", "odom"), odometry.frame());
    assertEquals(new FrameId("robby", "base"), odometry.childFrame());
    assertEquals(new Vector3(1, 2, 0), odometry.pose().translation());
    assertEquals(0.5, odometry.linear().x());
    StampedPose pose = converted("Pose", StampedPose.class, NamedRecord.of("header", header("frame_id", "world"),
        "position", vector(3, 0, 0), "orientation", NamedRecord.of("w", 1)));
    assertEquals(new Vector3(3, 0, 0), pose.pose().translation());
  }

  @Test
  void jointsOfAModelAreThoseOfItsFirstAxes() {
    JointState joints = converted("Model", JointState.class, NamedRecord.of("joint", List.of(NamedRecord.of("name",
        "elbow", "axis1", NamedRecord.of("position", 1, "velocity", 2, "force", 3)))));
    assertEquals(List.of(new JointState.Joint("elbow", 1, 2, 3)), joints.joints());
  }

  @Test
  void degreesOfAFixBecomeRadians() {
    GpsFix fix = converted("NavSat", GpsFix.class,
        NamedRecord.of("frame_id", "gps", "latitude_deg", 48.1, "longitude_deg", 11.6, "altitude", 520));
    assertEquals(new FrameId("robby", "gps"), fix.frame());
    assertEquals(Math.toRadians(48.1), fix.latitude(), 1e-9);
  }

  @ParameterizedTest
  @CsvSource({"40, 0.4", "100, 1", "101, NaN", "-1, NaN"})
  void aBatteryIsAShareOfOne(double percent, double share) {
    Battery battery = converted("BatteryState", Battery.class,
        NamedRecord.of("voltage", 12, "percentage", percent, "power_supply_status", "CHARGING"));
    assertEquals(share, battery.charge());
    assertEquals(Battery.Status.CHARGING, battery.status());
  }
}
