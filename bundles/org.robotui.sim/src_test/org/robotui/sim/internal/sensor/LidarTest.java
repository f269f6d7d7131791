package org.robotui.sim.internal.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.TestWorlds;
import org.robotui.sim.internal.world.Walker;
import org.robotui.sim.internal.world.World;

class LidarTest {
  private static final LidarSpec EXACT = new LidarSpec(4, 3, -0.4, 0.4, 0.1, 10, 0, 0, 0, 0.5);

  @Test
  void aLevelBeamMeetsTheWallsAndALowOneTheFloor() {
    float[] points = new Lidar(EXACT, new Random(1)).scan(TestWorlds.room(), new Pose2(5, 3, 0));
    assertEquals(4 * 3 * Lidar.NUMBERS, points.length);
    assertEquals(-0.5, points[2], 1e-6, "the floor, as seen from the scanner");
    assertEquals(0.5 / Math.tan(0.4), points[0], 1e-6);
    assertEquals(4.9, points[4], 1e-6, "the wall ahead");
    assertEquals(0, points[6], 1e-6);
    assertEquals(2.9, points[3 * Lidar.NUMBERS + 5], 1e-6, "the wall to the left");
  }

  @Test
  void aLowThingIsSeenFromAbove() {
    World table = TestWorlds.of(
        """
        room hall 0 0 10 6 tile 808080 c04040
        box ffffff 6 2 8 4 0.3
        start 5 3 0
        """);
    float[] points = new Lidar(EXACT, new Random(1)).scan(table, new Pose2(5.8, 3, 0));
    assertEquals(-0.2, points[2], 1e-6, "its upper side");
    assertEquals(0.2 / Math.tan(0.4), points[0], 1e-6);
    assertTrue(points[3] > 20, "white is bright");
  }

  @Test
  void inTheDemoACloudIsOfThousandsOfPointsWithinTheBuilding() {
    World world = World.demo();
    float[] points = new Lidar(LidarSpec.DEMO, new Random(1)).scan(world, world.start());
    int count = points.length / Lidar.NUMBERS;
    assertTrue(count > 8_000 && count < 16_000, count + " points");
    for (int i = 0; i < points.length; i += Lidar.NUMBERS) {
      double z = points[i + 2] + LidarSpec.DEMO.height();
      assertTrue(z > -0.1 && z < 2.6, "height " + z);
      assertTrue(Math.hypot(points[i], points[i + 1]) < 10.1 && points[i + 3] >= 0 && points[i + 3] <= 100);
    }
  }

  @Test
  void whoeverWalksByIsSeen() {
    World empty = TestWorlds.room();
    Pose2 robot = new Pose2(5, 3, 0);
    float[] points = new Lidar(EXACT, new Random(1)).scan(empty.with(Walker.body(new Pose2(7, 3, 0))), robot);
    assertEquals(1.82, points[4], 0.01);
  }
}
