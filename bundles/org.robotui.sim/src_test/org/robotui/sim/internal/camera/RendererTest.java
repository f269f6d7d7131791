package org.robotui.sim.internal.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.TestWorlds;
import org.robotui.sim.internal.world.World;

class RendererTest {
  private static final Lens LENS = new Lens(160, 120, Math.toRadians(70), 0, 0.6);

  @Test
  void theMiddleOfThePictureHasTheColourOfTheWall() {
    int[] pixels = new Renderer(TestWorlds.room(), LENS).render(new Pose2(5, 3, 0), Optional.empty(), Optional.empty());
    int middle = pixels[60 * 160 + 80];
    assertTrue(red(middle) > green(middle) + 40, Integer.toHexString(middle));
    assertEquals(green(middle), blue(middle), 12);
  }

  @Test
  void theFloorBeginsWhereTheWallEnds() {
    int[] pixels = new Renderer(TestWorlds.room(), LENS).render(new Pose2(5, 3, 0), Optional.empty(), Optional.empty());
    double line = 60 + 0.6 * LENS.focalLength() / 4.9;
    assertTrue(isReddish(pixels[((int) line - 5) * 160 + 80]));
    assertTrue(!isReddish(pixels[((int) line + 3) * 160 + 80]));
  }

  @Test
  void aLowBoxHidesTheWallOnlyBelowItsTop() {
    World world = TestWorlds.of(
        """
        room hall 0 0 10 6 tile 808080 c04040
        wall 10 0 10 6 0.2
        box 20c020 7 2 8 4 0.5
        start 5 3 0
        """);
    int[] pixels = new Renderer(world, LENS).render(new Pose2(5, 3, 0), Optional.empty(), Optional.empty());
    int below = pixels[75 * 160 + 80];
    assertTrue(green(below) > red(below) + 60, Integer.toHexString(below));
    assertTrue(isReddish(pixels[58 * 160 + 80]));
  }

  @Test
  void aGoalIsMarkedWhereItIs() {
    Renderer renderer = new Renderer(TestWorlds.room(), LENS);
    int line = (int) (60 - (0.9 - 0.6) * LENS.focalLength() / 2);
    int without = renderer.render(new Pose2(5, 3, 0), Optional.empty(), Optional.empty())[line * 160 + 80];
    int with = renderer.render(new Pose2(5, 3, 0), Optional.of(new Pose2(7, 3, 0)), Optional.empty())[line * 160 + 80];
    assertTrue(isReddish(without));
    assertTrue(green(with) > red(with) + 60, Integer.toHexString(with));
  }

  @Test
  void everyPixelOfTheDemoIsPainted() {
    Renderer renderer = new Renderer(World.demo(), LENS);
    for (int turn = 0; turn < 8; turn++) {
      for (int pixel : renderer.render(new Pose2(2.6, 2.3, turn * Math.PI / 4), Optional.empty(), Optional.empty())) {
        assertTrue(pixel > 0 && pixel <= 0xffffff, Integer.toHexString(pixel));
      }
    }
  }

  private static boolean isReddish(int colour) {
    return red(colour) > green(colour) + 40;
  }

  private static int red(int colour) {
    return colour >> 16 & 255;
  }

  private static int green(int colour) {
    return colour >> 8 & 255;
  }

  private static int blue(int colour) {
    return colour & 255;
  }
}
