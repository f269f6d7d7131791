package org.robotui.entity.gridmap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.navigation.GridMap;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.Bounds;

class GridMapEntityTest {
  private static final FrameId FRAME = new FrameId("Keira", "map");
  /** As in the map of the navigation stack's tests: turned by a radian. */
  private static final RigidTransform ORIGIN = RigidTransform.planar(2, 3, 1);

  @Test
  void cellsOfATurnedMapAreFoundWhereTheyLie() {
    byte[] cells = new byte[10 * 5];
    cells[2 * 10 + 7] = 100;
    cells[3 * 10] = -1;
    GridMapEntity entity = new GridMapEntity();
    entity.prepare(new GridMap(FRAME, 0.5, 10, 5, ORIGIN, Bytes.of(cells)), RigidTransform.IDENTITY);
    assertEquals("map: occupied, 100\u00a0%", at(entity, 3.75, 1.25));
    assertEquals("map: free", at(entity, 3.25, 1.25));
    assertEquals("", at(entity, 0.25, 1.75));
    assertEquals("", at(entity, -0.25, 1.25));
  }

  @Test
  void boundsHoldTheTurnedMap() {
    GridMapEntity entity = new GridMapEntity();
    entity.prepare(new GridMap(FRAME, 1, 4, 2, ORIGIN, Bytes.of(new byte[8])), RigidTransform.planar(10, 0, 0));
    Bounds b = entity.bounds().orElseThrow();
    assertEquals(12 - 2 * Math.sin(1), b.minX(), 1e-9);
    assertEquals(12 + 4 * Math.cos(1), b.maxX(), 1e-9);
    assertEquals(3 + 4 * Math.sin(1) + 2 * Math.cos(1), b.maxY(), 1e-9);
  }

  @Test
  void withoutAMapThereIsNothing() {
    GridMapEntity entity = new GridMapEntity();
    assertTrue(entity.bounds().isEmpty());
    assertTrue(entity.describeAt(0, 0, 1).isEmpty());
  }

  private static String at(GridMapEntity entity, double inGridX, double inGridY) {
    Vector3 p = ORIGIN.apply(new Vector3(inGridX, inGridY, 0));
    return entity.describeAt(p.x(), p.y(), 0).map(d -> d.text()).orElse("");
  }
}
