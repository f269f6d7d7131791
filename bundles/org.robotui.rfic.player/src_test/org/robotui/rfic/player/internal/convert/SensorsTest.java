package org.robotui.rfic.player.internal.convert;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.Vector3;
import org.robotui.player.interfaces.Angles;
import org.robotui.player.interfaces.Camera;
import org.robotui.player.interfaces.Color;
import org.robotui.player.interfaces.Gps;
import org.robotui.player.interfaces.Laser;
import org.robotui.player.interfaces.Point3d;
import org.robotui.player.interfaces.Pointcloud3d;
import org.robotui.player.interfaces.Pose3d;
import org.robotui.player.interfaces.Power;
import org.robotui.player.interfaces.Ranger;

class SensorsTest {
  private static final FrameId FRAME = new FrameId("r", "sensor_0");
  private static final FrameNames NAMES = new FrameNames("r", new FrameNames.Names("base_link", "odom", "map"));

  @Test
  void raysLieBetweenBothEnds() {
    LaserScan scan = Scans.of(new Laser.Scan(-1.5f, 1.5f, 0.9f, 8, new float[]{1, 2, 3, 8}, new byte[0], 1), FRAME);
    assertEquals(1, scan.angleIncrement(), 1e-6, "the resolution is rounded by drivers");
    assertEquals(Float.POSITIVE_INFINITY, scan.ranges().get(3));
    assertTrue(scan.isEcho(2));
    assertEquals(0, scan.intensities().size());
  }

  @Test
  void scansOfOddDevicesAreStillScans() {
    assertEquals(0, Scans.of(new Laser.Scan(0, 1, 0.1f, 8, new float[0], new byte[0], 1), FRAME).ranges().size());
    assertEquals(0,
        Scans.of(new Laser.Scan(0, 1, 0.1f, 8, new float[]{1}, new byte[]{1, 2}, 1), FRAME).intensities().size());
    LaserScan unbounded = Scans.of(new Laser.Scan(0, 1, 0.1f, 0, new float[]{1, 90}, new byte[0], 1), FRAME);
    assertTrue(unbounded.isEcho(1), "a device that does not say how far it sees is believed");
    assertThrows(IllegalArgumentException.class,
        () -> Scans.of(new Laser.Scan(0, Float.NaN, 0, 8, new float[]{1, 2}, new byte[0], 1), FRAME));
    assertThrows(IllegalArgumentException.class,
        () -> Scans.of(new double[]{1, 2}, new Ranger.Config(Double.NaN, 1, 1, 0, 8, 0, 10), FRAME));
  }

  @Test
  void aRangersConfigurationSaysHowItSees() {
    LaserScan scan = Scans.of(new double[]{0.05, 2, 8}, new Ranger.Config(-1, 1, 0, 0.1, 8, 0.01, 20), FRAME);
    assertEquals(0.1, scan.rangeMin());
    assertEquals(0.05, scan.scanTime());
    assertFalse(scan.isEcho(0));
    assertEquals(0, Scans.of(new double[]{1}, new Ranger.Config(0, 0, 0, -3, 8, 0, 0), FRAME).rangeMin());
  }

  @Test
  void sonarsSeeNothingAtTheirFarthest() {
    RangeReadings readings = Sonars.of(new double[]{1, 5, Double.NaN}, new Sonars.Beam(0.3, 5),
        RangeReading.Kind.ULTRASOUND, NAMES, "sonar:2");
    assertEquals(new FrameId("r", "sonar_2_0"), readings.readings().getFirst().frame());
    assertTrue(readings.readings().get(0).isEcho());
    assertEquals(Double.POSITIVE_INFINITY, readings.readings().get(1).range());
    assertFalse(readings.readings().get(2).isEcho());
    assertEquals(new Sonars.Beam(0.2618, 4),
        new Sonars.Beam(0.3, 5).told(new Ranger.Config(-0.1309, 0.1309, 0, 0, 4, 0, 0)));
    assertEquals(new Sonars.Beam(0.3, 5),
        new Sonars.Beam(0.3, 5).told(new Ranger.Config(0, Double.NaN, 0, 0, Double.NaN, 0, 0)));
  }

  @Test
  void onlyWhatAPowerDeviceFillsCounts() {
    Battery full = States.battery(new Power.State(27, 24, 80, 0, -48, 1));
    assertEquals(new Battery(24, -2, 0.8f * 1.0, Battery.Status.CHARGING).voltage(), full.voltage());
    assertEquals(-2, full.current());
    assertEquals(0.8, full.charge(), 1e-6);
    assertEquals(Battery.Status.CHARGING, full.status());
    Battery little = States.battery(new Power.State(1, 12, 80, 0, -48, 1));
    assertTrue(Double.isNaN(little.charge()) && Double.isNaN(little.current()));
    assertEquals(Battery.Status.UNKNOWN, little.status());
    assertEquals(Battery.Status.DISCHARGING, States.battery(new Power.State(2, 0, 0, 0, -5, 0)).status());
    assertEquals(Battery.Status.NOT_CHARGING, States.battery(new Power.State(16, 0, 0, 0, 0, 0)).status());
    assertTrue(Double.isNaN(States.battery(new Power.State(8, 0, 250, 0, 0, 0)).charge()),
        "no battery is fuller than full");
  }

  @Test
  void picturesOfEveryFormat() {
    byte[] grey = {1, 2};
    assertEquals(PixelEncoding.MONO8,
        ((RawImage) Pictures.of(new Camera.Image(2, 1, 8, 1, 1, 0, grey), FRAME)).encoding());
    RawImage deep = (RawImage) Pictures.of(new Camera.Image(1, 1, 16, 2, 1, 0, grey), FRAME);
    assertTrue(deep.bigEndian());
    assertEquals(PixelEncoding.MONO16, deep.encoding());
    RawImage wide =
        (RawImage) Pictures.of(new Camera.Image(2, 1, 16, 4, 1, 0, new byte[]{0, (byte) 0xf8, (byte) 0x1f, 0}), FRAME);
    assertEquals(PixelEncoding.RGB8, wide.encoding());
    assertEquals(255, wide.pixels().unsigned(0));
    assertEquals(0, wide.pixels().unsigned(2));
    assertEquals(255, wide.pixels().unsigned(5));
    assertEquals(6, ((RawImage) Pictures.of(new Camera.Image(2, 1, 24, 5, 1, 0, new byte[6]), FRAME)).step());
    assertEquals("jpeg",
        assertInstanceOf(CompressedImage.class, Pictures.of(new Camera.Image(2, 1, 24, 5, 1, 1, grey), FRAME))
            .format());
  }

  @Test
  void picturesThatCannotBeAreRefused() {
    assertThrows(IllegalArgumentException.class,
        () -> Pictures.of(new Camera.Image(100, 100, 24, 5, 1, 0, new byte[6]), FRAME));
    assertThrows(IllegalArgumentException.class,
        () -> Pictures.of(new Camera.Image(100, 100, 16, 4, 1, 0, new byte[6]), FRAME));
    assertThrows(IllegalArgumentException.class,
        () -> Pictures.of(new Camera.Image(0xffffffffL, 0xffffffffL, 24, 5, 1, 0, new byte[6]), FRAME));
    assertThrows(IllegalArgumentException.class,
        () -> Pictures.of(new Camera.Image(0xffffffffL, 0, 24, 5, 1, 0, new byte[6]), FRAME));
    assertThrows(IllegalArgumentException.class,
        () -> Pictures.of(new Camera.Image(1, 1, 24, 3, 1, 0, new byte[6]), FRAME));
    assertThrows(IllegalArgumentException.class,
        () -> Pictures.of(new Camera.Image(1, 1, 24, 5, 1, 2, new byte[6]), FRAME));
  }

  @Test
  void inertialUnitsSayWhatTheyMeasure() {
    var measured = new org.robotui.player.interfaces.Imu.Calibrated(1, 2, 3, 4, 5, 6, 7, 8, 9);
    Imu plain = Sensing.imu(measured, FRAME);
    assertEquals(Optional.of(new Vector3(1, 2, 3)), plain.linearAcceleration());
    assertEquals(Optional.of(new Vector3(4, 5, 6)), plain.angularVelocity());
    assertTrue(plain.orientation().isEmpty());
    Imu turned = Sensing.imu(new org.robotui.player.interfaces.Imu.Quaternion(measured, 2, 0, 0, 0), FRAME);
    assertEquals(1, turned.orientation().orElseThrow().w(), 1e-12);
    assertThrows(IllegalArgumentException.class,
        () -> Sensing.imu(new org.robotui.player.interfaces.Imu.Quaternion(measured, 0, 0, 0, 0), FRAME));
    Imu euler = Sensing.imu(new org.robotui.player.interfaces.Imu.Euler(measured, new Angles(0.1, 0.2, 0.3)), FRAME);
    assertEquals(0.2, euler.orientation().orElseThrow().pitch(), 1e-12);
    Pose3d pose = new Pose3d(1, 2, 3, 0, 0, 0.4);
    assertEquals(0.4,
        Sensing.imu(new org.robotui.player.interfaces.Imu.State(pose), FRAME).orientation().orElseThrow().yaw(), 1e-12);
    Imu all =
        Sensing.imu(new org.robotui.player.interfaces.Imu.FullState(pose, new Pose3d(0, 0, 0, 1, 2, 3), pose), FRAME);
    assertEquals(Optional.of(new Vector3(1, 2, 3)), all.angularVelocity());
    assertEquals(Optional.of(new Vector3(1, 2, 3)), all.linearAcceleration());
  }

  @Test
  void positionsOnEarthAreInRadiansAndMetres() {
    GpsFix fix =
        Sensing.fix(new Gps.State(1, 2, 481234567, -115000000, 519_000, 0, 0, 0, 0, 2, 7, 9, 9, 1.5, 2), FRAME);
    assertEquals(Math.toRadians(48.1234567), fix.latitude(), 1e-12);
    assertEquals(Math.toRadians(-11.5), fix.longitude(), 1e-12);
    assertEquals(519, fix.altitude());
    assertEquals(1.5, fix.horizontalAccuracy());
    assertEquals(GpsFix.Quality.GROUND_AUGMENTED, fix.quality());
    Gps.State none = new Gps.State(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    assertEquals(GpsFix.Quality.NO_FIX, Sensing.fix(none, FRAME).quality());
    assertTrue(Double.isNaN(Sensing.fix(none, FRAME).horizontalAccuracy()));
    assertThrows(IllegalArgumentException.class,
        () -> Sensing.fix(new Gps.State(0, 0, 2_000_000_000, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), FRAME));
  }

  @Test
  void pointsKeepTheirColours() {
    PointCloud cloud = Sensing.cloud(new Pointcloud3d.Cloud(List.of(
        new Pointcloud3d.Dot(new Point3d(1, 2, 3), new Color(255, 0x11, 0x22, 0x33)),
        new Pointcloud3d.Dot(new Point3d(Double.NaN, 0, 0), new Color(255, 0, 0, 0)))), FRAME);
    assertEquals(2, cloud.size());
    assertFalse(cloud.dense());
    var buffer = cloud.points().buffer(cloud.order());
    assertEquals(3f, buffer.getFloat(8));
    assertEquals(0x112233, buffer.getInt(12));
    assertEquals(0, Sensing.cloud(new Pointcloud3d.Cloud(List.of()), FRAME).size());
  }
}
