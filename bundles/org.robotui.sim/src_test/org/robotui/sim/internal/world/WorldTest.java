package org.robotui.sim.internal.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class WorldTest {
  private final World room = TestWorlds.room();

  @Test
  void rangesInARoomAreThoseOfGeometry() {
    assertEquals(4.9, room.range(5, 3, 0, 0.3, 20), 1e-9);
    assertEquals(2.9, room.range(5, 3, Math.PI / 2, 0.3, 20), 1e-9);
    assertEquals(4.9, room.range(5, 3, Math.PI, 0.3, 20), 1e-9);
    double angle = Math.toRadians(50);
    assertEquals(2.9 / Math.sin(angle), room.range(5, 3, angle, 0.3, 20), 1e-9);
  }

  @Test
  void nothingWithinTheLimitIsInfinite() {
    assertEquals(Double.POSITIVE_INFINITY, room.range(5, 3, 0, 0.3, 4.8));
  }

  @Test
  void aBodyIsFreeUntilItTouches() {
    assertTrue(room.isFree(0.36, 3, 0.25, 0.6));
    assertFalse(room.isFree(0.34, 3, 0.25, 0.6));
  }

  @Test
  void roomsAreFoundByPlace() {
    World demo = World.demo();
    assertEquals("kitchen", demo.roomAt(7, 7).orElseThrow().name());
    assertTrue(demo.roomAt(-1, -1).isEmpty());
  }
}
