package org.robotui.data;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteOrder;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.command.MotionLimits;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.Footprint;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.data.joint.RobotDescription;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.Bumper;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.data.sensor.RangeReading;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

class ValidationTest {
  private static final FrameId FRAME = new FrameId("robby", "base_link");

  @Test
  void everyTypeNamesTheComponentThatIsWrong() {
    assertRefused("angleMin", () -> scan(Double.NaN, 0, 10, Floats.of(1), Floats.EMPTY));
    assertRefused("rangeMin", () -> scan(0, -1, 10, Floats.of(1), Floats.EMPTY));
    assertRefused("rangeMax", () -> scan(0, 2, 1, Floats.of(1), Floats.EMPTY));
    assertRefused("intensities", () -> scan(0, 0, 1, Floats.of(1, 2), Floats.of(1)));
    assertRefused("fieldOfView", () -> reading(Double.NaN, 1));
    assertRefused("cells", () -> new GridMap(FRAME, 0.1, 2, 2, RigidTransform.IDENTITY, Bytes.of((byte) 0)));
    assertRefused("resolution", () -> new GridMap(FRAME, 0, 0, 0, RigidTransform.IDENTITY, Bytes.EMPTY));
    assertRefused("pixels",
        () -> new RawImage(FRAME, 4, 2, PixelEncoding.RGB8, false, 12, Bytes.wrap(new byte[23], 0, 23)));
    assertRefused("step", () -> new RawImage(FRAME, 4, 0, PixelEncoding.RGB8, false, 11, Bytes.EMPTY));
    assertRefused("corners", () -> new Footprint(FRAME, List.of(Vector3.ZERO, Vector3.ZERO)));
    assertRefused("charge", () -> new Battery(12, 1, 1.5, Battery.Status.UNKNOWN));
    assertRefused("latitude", () -> new GpsFix(FRAME, GpsFix.Quality.FIX, 42, 0, 0, 0));
    assertRefused("linear", () -> VelocityCommand.planar(Double.NaN, 0));
    assertRefused("length", () -> new Bumper(RigidTransform.IDENTITY, Double.POSITIVE_INFINITY, 0, false));
    assertRefused("radius", () -> new Bumper(RigidTransform.IDENTITY, 0.3, -0.1, false));
    assertRefused("robot", () -> new FrameId(" ", "base_link"));
    assertRefused("robot", () -> new RobotDescription("", "/robot_description", "<robot/>", "", List.of()));
    assertRefused("urdf", () -> new RobotDescription("robby", "/robot_description", " ", "", List.of()));
  }

  @Test
  void numbersThatNoRobotMeansAreRefused() {
    RigidTransform far = RigidTransform.planar(1e300, 0, 0);
    assertRefused("resolution", () -> map(1e30, RigidTransform.IDENTITY));
    assertRefused("resolution", () -> map(1e-30, RigidTransform.IDENTITY));
    assertRefused("resolution", () -> map(Double.NaN, RigidTransform.IDENTITY));
    assertRefused("origin.position", () -> map(0.05, far));
    assertRefused("origin.orientation", () -> map(0.05, new RigidTransform(Vector3.ZERO, new Quaternion(0, 0, 0, 0))));
    assertRefused("poses[1].position", () -> new Path(FRAME, List.of(RigidTransform.IDENTITY, far)));
    assertRefused("poses[0].position", () -> new PoseArray(FRAME, List.of(RigidTransform.planar(0, Double.NaN, 0))));
    assertRefused("pose.position", () -> new StampedPose(FRAME, far));
    assertRefused("pose.position", () -> new NavigationGoal(FRAME, far));
    assertRefused("pose.position", () -> new PoseEstimate(FRAME, far, Doubles.EMPTY));
    assertRefused("pose.position", () -> odometry(far, Vector3.ZERO));
    assertRefused("linear", () -> odometry(RigidTransform.IDENTITY, new Vector3(0, Double.NaN, 0)));
    assertRefused("pose.position", () -> new Bumper(far, 0.3, 0, false));
    assertRefused("corners", () -> new Footprint(FRAME, List.of(Vector3.ZERO, Vector3.ZERO, far.translation())));
    assertRefused("altitude", () -> new GpsFix(FRAME, GpsFix.Quality.FIX, 0.8, 0.2, 1e300, 0));
    assertFalse(scan(0, 0.1, Double.POSITIVE_INFINITY, Floats.of(3e38f), Floats.EMPTY).isEcho(0));
    assertDoesNotThrow(() -> map(0.05, RigidTransform.planar(1e6, -1e6, 3)));
  }

  private static GridMap map(double resolution, RigidTransform origin) {
    return new GridMap(FRAME, resolution, 100, 100, origin, Bytes.wrap(new byte[10_000], 0, 10_000));
  }

  private static Odometry odometry(RigidTransform pose, Vector3 linear) {
    return new Odometry(FRAME, FRAME, pose, Doubles.EMPTY, linear, Vector3.ZERO, Doubles.EMPTY);
  }

  @Test
  void hugeSizesDoNotOverflowTheCheck() {
    assertRefused("pointStep",
        () -> new PointCloud(FRAME, 1 << 20, 1 << 20, List.of(), 0, 0, ByteOrder.LITTLE_ENDIAN, true, Bytes.EMPTY));
    assertRefused("cells", () -> new GridMap(FRAME, 0.1, 1 << 16, 1 << 16, RigidTransform.IDENTITY, Bytes.EMPTY));
    assertRefused("points", () -> new PointCloud(FRAME, 1, Integer.MAX_VALUE, List.of(), 4, Integer.MAX_VALUE,
        ByteOrder.LITTLE_ENDIAN, true, Bytes.EMPTY));
    assertRefused("field x", () -> new PointCloud(FRAME, 1, 1,
        List.of(new PointField("x", 0, PointField.Format.FLOAT64, Integer.MAX_VALUE)), 8, 8, ByteOrder.LITTLE_ENDIAN,
        true, Bytes.wrap(new byte[8], 0, 8)));
  }

  @Test
  void rangesMeanWhatRep117Says() {
    LaserScan scan = scan(0, 0.5, 10,
        Floats.of(1, Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, 0.4f, 11), Floats.EMPTY);
    assertTrue(scan.isEcho(0));
    for (int beam = 1; beam < scan.ranges().size(); beam++) {
      assertFalse(scan.isEcho(beam), "beam " + beam);
    }
    assertTrue(reading(0.3, 1).isEcho());
    assertFalse(reading(0.3, Double.POSITIVE_INFINITY).isEcho());
  }

  @Test
  void framesForgetTheSlashOfOldTransforms() {
    assertEquals(FRAME, new FrameId("robby", "/base_link"));
  }

  @Test
  void motionIsScaledInItsDirection() {
    VelocityCommand fast = VelocityCommand.planar(2, 1);
    assertEquals(VelocityCommand.planar(0.5, 0.25), fast.within(new MotionLimits(0.5, 10)));
    assertEquals(VelocityCommand.planar(1, 0.5), fast.within(new MotionLimits(10, 0.5)));
    assertEquals(fast, fast.within(MotionLimits.NONE));
    assertEquals(VelocityCommand.ZERO, fast.within(new MotionLimits(0, 0)));
  }

  @Test
  void stampsOfDifferentClocksHaveNoDifference() {
    assertThrows(IllegalArgumentException.class,
        () -> new Stamp(1, ClockKind.WALL).since(new Stamp(0, ClockKind.ROBOT)));
    assertDoesNotThrow(() -> new Stamp(1, ClockKind.WALL).since(new Stamp(0, ClockKind.WALL)));
  }

  private static LaserScan scan(double angleMin, double rangeMin, double rangeMax, Floats ranges, Floats intensities) {
    return new LaserScan(FRAME, angleMin, 0.1, rangeMin, rangeMax, 0, ranges, intensities);
  }

  private static RangeReading reading(double fieldOfView, double range) {
    return new RangeReading(FRAME, RangeReading.Kind.ULTRASOUND, fieldOfView, 0.1, 5, range);
  }

  private static void assertRefused(String component, Executable make) {
    String message = assertThrows(IllegalArgumentException.class, make).getMessage();
    assertTrue(message.startsWith(component + ":"), message);
  }
}
