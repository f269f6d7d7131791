package org.robotui.entity.odometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.Bounds;

class OdometryEntityTest {
  private static final double ENDLESS = 1e9;

  @Test
  void aTrailIsBoundedAndKeepsBothEnds() {
    Trail trail = new Trail(100);
    for (int i = 0; i <= 100_000; i++) {
      trail.add(i * 0.01, 0);
    }
    double[] xy = trail.points();
    assertTrue(trail.count() <= 100, trail.count() + " points");
    assertEquals(0, xy[0], 1e-9);
    assertTrue(xy[xy.length - 2] > 980, "ends at " + xy[xy.length - 2]);
  }

  @Test
  void aTrailIgnoresStandingStillAndNonsense() {
    Trail trail = new Trail(10);
    trail.add(1, 1);
    trail.add(1.001, 1);
    trail.add(Double.NaN, 2);
    assertEquals(1, trail.count());
  }

  @Test
  void aTrailIsCutToItsLength() {
    Trail trail = new Trail(1000);
    for (int i = 0; i <= 100; i++) {
      trail.add(i * 0.1, 0);
    }
    trail.cut(2.05);
    double[] xy = trail.points();
    assertEquals(10, xy[xy.length - 2], 1e-9);
    assertEquals(7.9, xy[0], 0.11);
  }

  @Test
  void theWholeWayMovesWithTheFrameOfTheOdometry() {
    OdometryEntity entity = new OdometryEntity(0);
    entity.prepare(at("odom", 0, 0), RigidTransform.IDENTITY, ENDLESS);
    entity.prepare(at("odom", 2, 0), RigidTransform.planar(10, 5, 0), ENDLESS);
    assertEquals(new Bounds(10, 5, 12, 5), entity.bounds().orElseThrow());
  }

  @Test
  void anotherFrameOrAJumpOfTheClockBeginsAnew() {
    OdometryEntity entity = new OdometryEntity(0);
    entity.prepare(at("odom", 0, 0), RigidTransform.IDENTITY, ENDLESS);
    entity.prepare(at("wheels", 3, 0), RigidTransform.IDENTITY, ENDLESS);
    assertEquals(new Bounds(3, 0, 3, 0), entity.bounds().orElseThrow());
    entity.clear();
    assertTrue(entity.bounds().isEmpty());
  }

  @Test
  void theWayIsDescribedByItsNewestPose() {
    OdometryEntity entity = new OdometryEntity(0);
    entity.prepare(at("odom", 2, -1), RigidTransform.IDENTITY, ENDLESS);
    String text = entity.describeAt(2.01, -1, 0.1).orElseThrow().text();
    assertTrue(text.contains("x 2.00  y \u22121.00\u00a0m"), text);
    assertTrue(text.contains("0.25\u00a0m/s"), text);
  }

  private static Odometry at(String frame, double x, double y) {
    return new Odometry(new FrameId("Keira", frame), new FrameId("Keira", "base"), RigidTransform.planar(x, y, 0),
        Doubles.EMPTY, new Vector3(0.25, 0, 0), Vector3.ZERO, Doubles.EMPTY);
  }
}
