package org.robotui.entity.laserscan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.array.Floats;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

class ScanShapeTest {
  private static final FrameId LASER = new FrameId("Keira", "laser");
  private static final float FREE = Float.POSITIVE_INFINITY;

  @Test
  void onlyRangesWithinTheLimitsAreEchoes() {
    ScanShape shape = ScanShape.of(scan(0.05f, 2, FREE, Float.NaN, Float.NEGATIVE_INFINITY, 11, 10), at(0, 0, 0));
    assertEquals(2, shape.echoCount());
    assertEquals("[1, 6]", Arrays.toString(shape.beams()));
  }

  @Test
  void anEchoAtAnAngleBeyondAllNumbersIsNotAPlace() {
    LaserScan endless = new LaserScan(LASER, 1e308, 1e308, 0, 10, 0.1, Floats.of(2f, 3f), Floats.EMPTY);
    assertEquals(1, ScanShape.of(endless, at(0, 0, 0)).echoCount());
  }

  @Test
  void theFanReachesToTheLimitOnlyWhereTheBeamWasFree() {
    ScanShape shape = ScanShape.of(scan(2, FREE, Float.NaN, 0.05f, 11), at(1, 1, 0));
    double[] lengths = new double[5];
    for (int i = 0; i < lengths.length; i++) {
      lengths[i] = Math.hypot(shape.fan()[2 * i + 2] - 1, shape.fan()[2 * i + 3] - 1);
    }
    assertEquals(2, lengths[0], 1e-6);
    assertEquals(10, lengths[1], 1e-6);
    assertEquals(0, lengths[2], 1e-6);
    assertEquals(0, lengths[3], 1e-6);
    assertEquals(10, lengths[4], 1e-6);
  }

  @Test
  void echoesLieInTheFixedFrame() {
    ScanShape shape = ScanShape.of(scan(2), at(5, 1, Math.PI / 2));
    assertEquals(5, shape.echoes()[0], 1e-9);
    assertEquals(3, shape.echoes()[1], 1e-9);
  }

  @Test
  void aScannerMountedUpsideDownIsMirrored() {
    Quaternion over = Quaternion.fromRollPitchYaw(Math.PI, 0, 0);
    LaserScan left = new LaserScan(LASER, Math.PI / 2, 0.1, 0.1, 10, 0, Floats.of(2), Floats.EMPTY);
    ScanShape shape = ScanShape.of(left, new RigidTransform(Vector3.ZERO, over));
    assertEquals(-2, shape.echoes()[1], 1e-9);
  }

  @Test
  void thousandsOfBeamsMakeAFanOfBoundedSizeThatNeverClaimsMoreThanWasMeasured() {
    float[] ranges = new float[7200];
    Arrays.fill(ranges, 9);
    ranges[3605] = 1;
    ScanShape shape = ScanShape.of(
        new LaserScan(LASER, 0, 0.0005, 0.1, 10, 0, Floats.of(ranges), Floats.EMPTY), at(0, 0, 0));
    assertTrue(shape.fan().length / 2 <= 721, shape.fan().length + " numbers");
    double shortest = 10;
    for (int i = 1; i < shape.fan().length / 2; i++) {
      shortest = Math.min(shortest, Math.hypot(shape.fan()[2 * i], shape.fan()[2 * i + 1]));
    }
    assertEquals(1, shortest, 1e-6);
  }

  @Test
  void theNearestEchoUnderThePointerIsDescribed() {
    LaserScanEntity entity = new LaserScanEntity();
    assertTrue(entity.bounds().isEmpty());
    entity.prepare(scan(2, 4), at(0, 0, 0));
    assertTrue(entity.describeAt(1.95, 0, 0.1).orElseThrow().text().startsWith("echo 2.00\u00a0m at 0.0\u00b0"));
    assertTrue(entity.describeAt(3, 0, 0.1).isEmpty());
    entity.clear();
    assertTrue(entity.describeAt(2, 0, 0.1).isEmpty());
  }

  private static LaserScan scan(float... ranges) {
    return new LaserScan(LASER, 0, 0.1, 0.1, 10, 0, Floats.of(ranges), Floats.EMPTY);
  }

  private static RigidTransform at(double x, double y, double yaw) {
    return RigidTransform.planar(x, y, yaw);
  }
}
