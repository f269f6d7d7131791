package org.robotui.sim.internal.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class FloorPlanReaderTest {
  @Test
  void aDoorLeavesAGapWithALintelAboveIt() {
    World world = TestWorlds.of(
        """
        room hall 0 0 4 4 plank 808080 a0a0a0
        wall 0 2 4 2 0.1 door 1 2
        start 1 1 90
        """);
    assertEquals(Double.POSITIVE_INFINITY, world.range(1.5, 1, Math.PI / 2, 0.3, 3));
    assertEquals(0.95, world.range(1.5, 1, Math.PI / 2, 2.3, 3), 1e-9);
    assertEquals(0.95, world.range(3, 1, Math.PI / 2, 0.3, 3), 1e-9);
    assertTrue(world.isFree(1.5, 2, 0.3, 0.6));
    assertFalse(world.isFree(3, 2, 0.3, 0.6));
  }

  @Test
  void anErrorNamesTheLineAndWhatIsWrong() {
    IllegalArgumentException e = assertThrows(
        IllegalArgumentException.class, () -> TestWorlds.of("# a comment\nbox 00ff00 1 2 3\n"));
    assertTrue(e.getMessage().contains("line 2"), e.getMessage());
    assertTrue(e.getMessage().contains("ends too early"), e.getMessage());
  }

  @Test
  void unknownWordsAndAMissingStartAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> TestWorlds.of("sofa 1 2 3"));
    IllegalArgumentException e = assertThrows(
        IllegalArgumentException.class, () -> TestWorlds.of("room a 0 0 1 1 tile 000000 000000"));
    assertTrue(e.getMessage().contains("start"), e.getMessage());
  }

  @Test
  void theDemoHasRoomsAndAFreeStart() {
    World world = World.demo();
    assertEquals(7, world.rooms().size());
    assertTrue(world.isFree(world.start().x(), world.start().y(), 0.3, 0.65));
  }
}
