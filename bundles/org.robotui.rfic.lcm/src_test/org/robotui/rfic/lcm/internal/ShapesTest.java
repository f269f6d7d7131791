package org.robotui.rfic.lcm.internal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.Image;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.data.joint.JointState;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.geometry.Vector3;
import org.robotui.lcm.type.TypeFolder;

/** What messages become: our own types without further words, and other robots' types with them. */
class ShapesTest {
  private static final double EPS = 1e-9;

  private Mapped ours;

  @BeforeEach
  void readTypes() throws IOException {
    ours = new Mapped(TypeFolder.read(List.of(Written.types())));
  }

  private static Map<String, Object> fields(Object... namesAndValues) {
    return Written.map(namesAndValues);
  }

  @Test
  void odometryOfOurOwnTypeNeedsNoWords() throws Exception {
    Odometry odometry = ours.convert(Odometry.class, "robotui.odometry_t",
        fields("utime", 5, "frame", "odom", "child_frame", "base",
            "position", List.of(1, 2, 0), "orientation", List.of(Math.sqrt(0.5), 0, 0, Math.sqrt(0.5)),
            "linear_velocity", List.of(0.5, 0, 0),
            "angular_velocity", List.of(0, 0, 0.25)),
        "odometry");
    assertEquals("odom", odometry.frame().name());
    assertEquals("base", odometry.childFrame().name());
    assertEquals(new Vector3(1, 2, 0), odometry.pose().translation());
    assertEquals(Math.PI / 2, odometry.pose().rotation().yaw(), EPS);
    assertEquals(0.5, odometry.linear().x(), EPS);
    assertEquals(0.25, odometry.angular().z(), EPS);
  }

  @Test
  void odometryOfAnotherRobotIsMappedByMembersAndUnits() throws Exception {
    Mapped theirs = Mapped.declaring(
        "package other; struct where_t { int64_t usec; int32_t pos[2]; float heading; float speed; float orientation[4]; }");
    Odometry odometry = theirs.convert(Odometry.class, "other.where_t",
        fields("pos", List.of(1500, -250), "heading", 90f, "speed", 36f),
        fields("as", "odometry", "frame", "odom", "child", "base_link", "x", "pos[0] mm", "y", "-pos.1 mm", "yaw",
            "heading deg", "vx", "speed km/h",
            "stamp", "usec us"));
    assertEquals(new Vector3(1.5, 0.25, 0), odometry.pose().translation());
    assertEquals(Math.PI / 2, odometry.pose().rotation().yaw(), 1e-6);
    assertEquals(10, odometry.linear().x(), 1e-6);
    assertEquals("base_link", odometry.childFrame().name());
  }

  @Test
  void aQuaternionMayEndWithItsScalar() throws Exception {
    Mapped theirs = Mapped.declaring("struct p_t { double q[4]; double pos[3]; }");
    PoseEstimate pose =
        theirs.convert(PoseEstimate.class, "p_t", fields("q", List.of(0, 0, 1, 0), "pos", List.of(1, 2, 3)),
            fields("as", "pose", "orientation", "q xyzw"));
    assertEquals(Math.PI, Math.abs(pose.pose().rotation().yaw()), EPS);
    assertEquals(3, pose.pose().translation().z());
  }

  @Test
  void aScanHasItsRangesInMetres() throws Exception {
    LaserScan ours1 = ours.convert(LaserScan.class, "robotui.laser_t",
        fields("frame", "laser", "angle_min", -1, "angle_increment", 1, "range_min", 0.1,
            "range_max", 30, "ranges", List.of(1, 2, Double.POSITIVE_INFINITY)),
        "laserscan");
    assertEquals(3, ours1.ranges().size());
    assertEquals(2f, ours1.ranges().get(1));
    assertEquals(30, ours1.rangeMax());
    Mapped theirs = Mapped.declaring("struct lidar_t { int32_t n; int16_t mm[n]; }");
    LaserScan scan = theirs.convert(LaserScan.class, "lidar_t", fields("mm", List.of(1000, 0, 3000)),
        fields("as", "laserscan", "ranges", "mm mm", "angle_min", "-90 deg", "angle_max", "90 deg", "no_echo", "0"));
    assertEquals(Math.PI / 2, scan.angleIncrement(), EPS);
    assertEquals(1f, scan.ranges().get(0));
    assertEquals(Float.POSITIVE_INFINITY, scan.ranges().get(1));
  }

  @Test
  void eachSonarHasAFrameWhereItIsMounted() throws Exception {
    RangeReadings ranges = ours.convert(RangeReadings.class, "robotui.ranges_t",
        fields("frame", "base", "field_of_view", 0.5, "range_max", 3,
            "ranges", List.of(1, 2), "x", List.of(0.1, 0.2), "y", List.of(0, 0), "z", List.of(0, 0), "yaw",
            List.of(0, 1)),
        "ranges");
    assertEquals(List.of("channel_0", "channel_1"), ranges.readings().stream().map(r -> r.frame().name()).toList());
    assertEquals(0.5, ranges.readings().getFirst().fieldOfView());
    assertEquals("base", ours.transforms.get(1).parent().name());
    assertEquals(0.2f, (float) ours.transforms.get(1).parentFromChild().translation().x());
    assertEquals(1, ours.transforms.get(1).parentFromChild().rotation().yaw(), 1e-6);
  }

  @Test
  void cellsOfAMapAreTakenAsTheyAreOrScaled() throws Exception {
    GridMap map = ours.convert(GridMap.class, "robotui.map_t",
        fields("frame", "map", "resolution", 0.05, "origin", List.of(-1, -2, 0),
            "cells", List.of(List.of(0, 100, -1), List.of(50, 0, 0))),
        "gridmap");
    assertEquals(3, map.width());
    assertEquals(2, map.height());
    assertEquals(-1, map.cell(2, 0));
    assertEquals(50, map.cell(0, 1));
    assertEquals(-2, map.origin().translation().y());
    Mapped theirs = Mapped.declaring("struct grid_t { int32_t w; int32_t h; int32_t n; byte data[n]; float cm; }");
    GridMap scaled =
        theirs.convert(GridMap.class, "grid_t", fields("w", 2, "h", 1, "data", List.of(255, 127), "cm", 10),
            fields("as", "gridmap", "cells", "data", "width", "w", "height", "h", "resolution", "cm cm", "free", "255",
                "occupied", "0", "unknown", "127"));
    assertEquals(0, scaled.cell(0, 0));
    assertEquals(-1, scaled.cell(1, 0));
    assertEquals(0.1, scaled.resolution(), 1e-6);
  }

  @Test
  void picturesAreFilesOrPixels() throws Exception {
    Image file = ours.convert(Image.class, "robotui.image_t",
        fields("frame", "camera", "encoding", "jpeg", "data", List.of(255, 216)), "image");
    assertEquals("jpeg", assertInstanceOf(CompressedImage.class, file).format());
    RawImage pixels = assertInstanceOf(RawImage.class, ours.convert(Image.class, "robotui.image_t",
        fields("encoding", "rgb8", "width", 2, "height", 1, "data", List.of(1, 2, 3, 4, 5, 6)), "image"));
    assertEquals(6, pixels.step());
    Mapped theirs =
        Mapped.declaring("struct image_t { int32_t width, height, row_stride, pixelformat, size; byte data[size]; }");
    RawImage grey = assertInstanceOf(RawImage.class,
        theirs.convert(Image.class, "image_t", fields("width", 2, "height", 1, "row_stride", 4,
            "pixelformat", 1497715271, "data", List.of(1, 2, 0, 0)), "image"));
    assertEquals(PixelEncoding.MONO8, grey.encoding());
    assertEquals(4, grey.step());
  }

  @Test
  void jointsStandInArraysOrInStructs() throws Exception {
    Mapped theirs =
        Mapped.declaring("struct joint_t { string name; float angle; } struct arm_t { int32_t n; joint_t joints[n]; }"
            + " struct state_t { int32_t n; string joint_name[n]; float joint_position[n]; }");
    JointState structs = theirs.convert(JointState.class, "arm_t",
        fields("joints", List.of(fields("name", "a", "angle", 180), fields("name", "b", "angle", 90))),
        fields("as", "jointstate", "position", "joints.*.angle deg"));
    assertEquals(List.of("a", "b"), structs.joints().stream().map(JointState.Joint::name).toList());
    assertEquals(Math.PI / 2, structs.joints().get(1).position(), 1e-6);
    JointState arrays = theirs.convert(JointState.class, "state_t",
        fields("joint_name", List.of("c"), "joint_position", List.of(0.5)), "jointstate");
    assertEquals(0.5, arrays.joints().getFirst().position());
    assertEquals(Double.NaN, arrays.joints().getFirst().velocity());
  }

  @Test
  void aWayHasThePosesOfItsStructs() throws Exception {
    Map<String, Object> start = fields("position", List.of(1, 0, 0), "orientation", List.of(1, 0, 0, 0));
    Map<String, Object> end = fields("position", List.of(2, 3, 0), "orientation", List.of(0, 0, 0, 1));
    Path path =
        ours.convert(Path.class, "robotui.path_t", fields("frame", "map", "poses", List.of(start, end)), "path");
    assertEquals(2, path.poses().size());
    assertEquals(new Vector3(2, 3, 0), path.poses().get(1).translation());
    assertEquals(Math.PI, Math.abs(path.poses().get(1).rotation().yaw()), EPS);
    assertEquals(0, ours.convert(Path.class, "robotui.path_t", fields("frame", "map"), "path").poses().size());
  }

  @Test
  void transformsAreToldToTheTree() throws Exception {
    Map<String, Object> one =
        fields("parent", "odom", "child", "base", "position", List.of(1, 2, 3), "orientation", List.of(1, 0, 0, 0));
    TransformSet set = ours.convert(TransformSet.class, "robotui.transforms_t",
        fields("utime", 7, "transforms", List.of(one)), "transforms");
    assertEquals("base", set.transforms().getFirst().child().name());
    assertEquals(7000, set.transforms().getFirst().stamp().nanos());
    assertEquals(set.transforms(), ours.transforms);
  }

  @Test
  void theRestOfOurOwnTypes() throws Exception {
    Imu imu = ours.convert(Imu.class, "robotui.imu_t",
        fields("orientation", List.of(1, 0, 0, 0), "angular_velocity", List.of(0, 0, 2),
            "acceleration", List.of(0, 0, 9.81)),
        "imu");
    assertEquals(2, imu.angularVelocity().orElseThrow().z());
    assertEquals(9.81, imu.linearAcceleration().orElseThrow().z());
    Battery battery = ours.convert(Battery.class, "robotui.battery_t",
        fields("level", 0.4, "voltage", 12, "current", -1, "charging", true), "battery");
    assertEquals(new Battery(12, -1, 0.4, Battery.Status.CHARGING), battery);
    LogEntry log =
        ours.convert(LogEntry.class, "robotui.log_t", fields("level", 3, "source", "pilot", "text", "lost"), "log");
    assertEquals(new LogEntry(Severity.ERROR, "pilot", "lost", ""), log);
    PoseEstimate pose = ours.convert(PoseEstimate.class, "robotui.pose_t",
        fields("frame", "map", "position", List.of(1, 2, 0)), "pose");
    assertEquals("map", pose.frame().name());
  }

  @Test
  void degreesOfSatellitesAndPointsOfClouds() throws Exception {
    Mapped theirs = Mapped.declaring(
        "struct gps_t { double latitude, longitude, elev; } struct cloud_t { int32_t n; float xyz[n][3]; int32_t flat[6]; }");
    GpsFix fix = theirs.convert(GpsFix.class, "gps_t", fields("latitude", 45, "longitude", -90, "elev", 100), "gps");
    assertEquals(Math.PI / 4, fix.latitude(), EPS);
    assertEquals(100, fix.altitude());
    PointCloud cloud =
        theirs.convert(PointCloud.class, "cloud_t", fields("xyz", List.of(List.of(1, 2, 3), List.of(4, 5, 6))),
            fields("as", "pointcloud", "points", "xyz"));
    assertEquals(2, cloud.size());
    float[] numbers = new float[6];
    cloud.points().buffer(cloud.order()).asFloatBuffer().get(numbers);
    assertArrayEquals(new float[]{1, 2, 3, 4, 5, 6}, numbers);
    assertEquals(2, theirs.convert(PointCloud.class, "cloud_t", fields("flat", List.of(1, 2, 3, 4, 5, 6)),
        fields("as", "pointcloud", "points", "flat mm")).size());
  }

  @Test
  void aTimeMayStandInTwoNumbers() throws Exception {
    Mapped theirs = Mapped.declaring("struct tf_t { int64_t sec; int32_t nsec; double pos[3]; }");
    TransformSet set = theirs.convert(TransformSet.class, "tf_t", fields("sec", 3, "nsec", 5),
        fields("as", "transform", "parent", List.of("odom"), "child", List.of("base"), "stamp",
            List.of("sec s", "nsec ns")));
    assertEquals(3_000_000_005L, set.transforms().getFirst().stamp().nanos());
  }
}
