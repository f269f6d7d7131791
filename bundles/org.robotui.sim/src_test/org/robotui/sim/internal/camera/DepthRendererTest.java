package org.robotui.sim.internal.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.TestWorlds;
import org.robotui.sim.internal.world.World;

class DepthRendererTest {
  private static final Lens LENS = new Lens(160, 120, Math.toRadians(72), 0.2, 0.62);
  private final DepthRenderer renderer = new DepthRenderer(TestWorlds.room(), LENS);

  private static int at(short[] depths, int x, int y) {
    return depths[y * 160 + x] & 0xffff;
  }

  @Test
  void wallFloorAndCeilingAreAsFarAsTheyAre() {
    short[] depths = renderer.render(new Pose2(5, 3, 0), Optional.empty());
    assertEquals(4700, at(depths, 80, 60), 1);
    assertEquals(4700, at(depths, 100, 60), 1);
    double f = LENS.focalLength();
    assertEquals(1000 * 0.62 * f / 49.5, at(depths, 80, 109), 1);
    assertEquals(1000 * (2.5 - 0.62) * f / 55.5, at(depths, 80, 4), 1);
  }

  @Test
  void somebodyInTheWayIsNearerThanTheWall() {
    short[] depths = renderer.render(new Pose2(5, 3, 0), Optional.of(new Pose2(7.2, 3, 0)));
    assertEquals(1870, at(depths, 80, 60), 5);
    assertEquals(4700, at(depths, 40, 60), 1);
  }

  @Test
  void theTopOfAThingLiesBetweenItsFrontAndItsBack() {
    World world = TestWorlds.of("room hall 0 0 10 6 tile 808080 c04040\nbox 00ff00 7 2 8 4 0.4\nstart 5 3 0\n");
    short[] depths = new DepthRenderer(world, LENS).render(new Pose2(5, 3, 0), Optional.empty());
    int front = -1;
    for (int y = 60; y < 120; y++) {
      front = front < 0 && Math.abs(at(depths, 80, y) - 1800) <= 1 ? y : front;
    }
    assertTrue(front > 60, "the front is seen");
    int top = at(depths, 80, front - 2);
    assertTrue(top > 1800 && top < 2800, "the top is at " + top);
  }

  @Test
  void whatIsTooNearOrTooFarIsNotMeasured() {
    assertEquals(0, at(renderer.render(new Pose2(9.5, 3, 0), Optional.empty()), 80, 60));
    World hall = TestWorlds.of("room hall 0 0 90 6 tile 808080 c04040\nwall 90 0 90 6 0.2\nstart 5 3 0\n");
    assertEquals(0, at(new DepthRenderer(hall, LENS).render(new Pose2(5, 3, 0), Optional.empty()), 80, 60));
  }
}
