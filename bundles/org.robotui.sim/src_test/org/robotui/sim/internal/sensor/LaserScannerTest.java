package org.robotui.sim.internal.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.MapRasterizer;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.TestWorlds;
import org.robotui.sim.internal.world.World;

class LaserScannerTest {
  private static final LaserSpec EXACT = new LaserSpec(Math.PI, 181, 0.05, 4, 0, 0, 0.3, 10);

  @Test
  void beamsGoFromRightToLeftAndStopAtWalls() {
    float[] ranges = new LaserScanner(() -> TestWorlds.room(), EXACT, new Random(1)).scan(new Pose2(7, 2, 0));
    assertEquals(1.9, ranges[0], 1e-6);
    assertEquals(2.9, ranges[90], 1e-6);
    assertEquals(3.9, ranges[180], 1e-6);
  }

  @Test
  void noEchoIsInfinite() {
    float[] ranges = new LaserScanner(() -> TestWorlds.room(), EXACT, new Random(1)).scan(new Pose2(5, 3, 0));
    assertEquals(Float.POSITIVE_INFINITY, ranges[90]);
  }

  @Test
  void theNoiseIsAsSpecified() {
    LaserSpec noisy = new LaserSpec(Math.PI, 181, 0.05, 8, 0.02, 0, 0.3, 10);
    LaserScanner scanner = new LaserScanner(() -> TestWorlds.room(), noisy, new Random(1));
    double squares = 0;
    for (int i = 0; i < 2000; i++) {
      double error = scanner.scan(new Pose2(5, 3, 0))[90] - 4.9;
      squares += error * error;
    }
    assertEquals(0.02, Math.sqrt(squares / 2000), 0.002);
  }

  @Test
  void inTheDemoEveryEchoLiesOnAnOccupiedCell() {
    World world = World.demo();
    GridMap map = new MapRasterizer(world, 0.05, LaserSpec.DEMO.height()).rasterize();
    Pose2 robot = world.start();
    float[] ranges = new LaserScanner(() -> world, LaserSpec.DEMO, new Random(1)).scan(robot);
    Pose2 eye = robot.times(new Pose2(LaserSpec.DEMO.forward(), 0, 0));
    int echoes = 0;
    for (int i = 0; i < ranges.length; i++) {
      double angle = eye.yaw() + LaserSpec.DEMO.angleMin() + i * LaserSpec.DEMO.increment();
      if (Float.isFinite(ranges[i])) {
        echoes++;
        assertTrue(isNearOccupied(map, eye.x() + ranges[i] * Math.cos(angle), eye.y() + ranges[i] * Math.sin(angle)));
      }
    }
    assertTrue(echoes > 330, "echoes: " + echoes);
  }

  private static boolean isNearOccupied(GridMap map, double x, double y) {
    for (int dr = -1; dr <= 1; dr++) {
      for (int dc = -1; dc <= 1; dc++) {
        if (map.at(map.column(x) + dc, map.row(y) + dr) == GridMap.OCCUPIED) {
          return true;
        }
      }
    }
    return false;
  }
}
