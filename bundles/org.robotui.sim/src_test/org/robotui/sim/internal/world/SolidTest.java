package org.robotui.sim.internal.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SolidTest {
  private final Solid box = Shapes.box(0x123456, 1, 1, 3, 2, 1);
  private final RaySpan span = new RaySpan();

  @Test
  void aRayEntersAndLeavesWhereTheBoxBeginsAndEnds() {
    assertTrue(box.clip(0, 1.5, 1, 0, span));
    assertEquals(1, span.enter(), 1e-12);
    assertEquals(3, span.exit(), 1e-12);
    assertEquals(-1, box.normalX(span.edge()), 1e-12);
  }

  @Test
  void aDiagonalRayMeetsTheSouthSide() {
    double s = Math.sqrt(0.5);
    assertTrue(box.clip(1, 0, s, s, span));
    assertEquals(Math.sqrt(2), span.enter(), 1e-12);
    assertEquals(-1, box.normalY(span.edge()), 1e-12);
  }

  @Test
  void raysBesideOrAwayFromTheBoxMissIt() {
    assertFalse(box.clip(0, 2.5, 1, 0, span));
    assertFalse(box.clip(0, 1.5, -1, 0, span));
  }

  @Test
  void aRayFromInsideHasNoEdgeOfEntry() {
    assertTrue(box.clip(2, 1.5, 1, 0, span));
    assertEquals(-1, span.edge());
    assertEquals(1, span.exit(), 1e-12);
  }

  @Test
  void distanceIsToTheNearestSideOrCornerAndNegativeInside() {
    assertEquals(0.5, box.distance(2, 2.5), 1e-12);
    assertEquals(Math.sqrt(2), box.distance(0, 0), 1e-12);
    assertEquals(-0.5, box.distance(2, 1.5), 1e-12);
  }

  @Test
  void aSlabOfAnyDirectionHasItsThickness() {
    Solid slab = Shapes.slab(Solid.Kind.WALL, 0, new Line(0, 0, 2, 2), 0.2, 0, 2.5);
    assertEquals(0.4, slab.distance(1 - 0.5 * Math.sqrt(0.5), 1 + 0.5 * Math.sqrt(0.5)), 1e-9);
    assertTrue(slab.covers(2.4));
    assertFalse(slab.covers(2.5));
  }

  @Test
  void aSolidWithoutHeightIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> Shapes.box(0, 0, 0, 1, 1, 0));
  }
}
