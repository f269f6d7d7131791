package org.robotui.sim.internal.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.TestWorlds;
import org.robotui.sim.internal.world.World;

class SonarRingTest {
  private static final String ROOM =
      """
      room hall 0 0 10 6 tile 808080 c04040
      wall 9.95 0 9.95 6 0.1
      start 5 3 0
      """;

  @Test
  void sixteenSensorsLookAllAround() {
    SonarRing ring = new SonarRing(() -> TestWorlds.room(), SonarSpec.PIONEER, new Random(1));
    assertEquals(16, ring.count());
    assertEquals(Math.toRadians(90), ring.mount(Pose2.ORIGIN, 0).yaw(), 1e-9);
    assertEquals(Math.toRadians(10), ring.mount(Pose2.ORIGIN, 3).yaw(), 1e-9);
    assertTrue(ring.mount(Pose2.ORIGIN, 11).x() < 0);
  }

  @Test
  void theConeFindsAThingBesideItsAxis() {
    SonarRing ring =
        new SonarRing(() -> TestWorlds.of(ROOM + "column 00ff00 6.5 3.0 0.1 1\n"), SonarSpec.PIONEER, new Random(1));
    Pose2 robot = new Pose2(5, 3, Math.toRadians(-10) - Math.toRadians(8));
    double withColumn = ring.measure(robot, 3);
    double without = new SonarRing(() -> TestWorlds.of(ROOM), SonarSpec.PIONEER, new Random(1)).measure(robot, 3);
    assertEquals(1.5 - 0.1 - 0.21, withColumn, 0.06);
    assertTrue(without > 4, "without the column " + without);
  }

  @Test
  void aWallAskewIsMeasuredAtItsNearestPointInTheCone() {
    World world = TestWorlds.of(ROOM);
    SonarRing ring = new SonarRing(() -> world, SonarSpec.PIONEER, new Random(1));
    Pose2 robot = new Pose2(8, 3, 0);
    Pose2 eye = ring.mount(robot, 2);
    double nearest = (9.9 - eye.x()) / Math.cos(Math.toRadians(30) - SonarSpec.PIONEER.cone() / 2);
    assertEquals(nearest, ring.measure(robot, 2), 0.05);
  }

  @Test
  void beyondTheRangeThereIsNoEcho() {
    SonarRing ring = new SonarRing(() -> TestWorlds.of(ROOM), SonarSpec.PIONEER, new Random(1));
    assertEquals(Double.POSITIVE_INFINITY, ring.measure(new Pose2(2, 3, Math.PI), 3));
  }
}
