package org.robotui.sim.internal.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class MapRasterizerTest {
  @Test
  void wallsAreOccupiedTheRoomIsFreeAndTheOutsideUnknown() {
    GridMap map = new MapRasterizer(TestWorlds.room(), 0.05, 0.3).rasterize();
    assertEquals(GridMap.OCCUPIED, at(map, 0.0, 3));
    assertEquals(GridMap.OCCUPIED, at(map, 5, 6.0));
    assertEquals(GridMap.FREE, at(map, 0.2, 0.2));
    assertEquals(GridMap.FREE, at(map, 9.8, 5.8));
    assertEquals(GridMap.UNKNOWN, at(map, -0.4, 3));
    assertEquals(GridMap.UNKNOWN, map.at(-1, 0));
  }

  @Test
  void rowsGoUpwardsFromTheOrigin() {
    World world = TestWorlds.of(
        """
        room hall 0 0 4 2 tile 808080 a0a0a0
        box 00ff00 3 1.5 4 2 0.5
        start 1 1 0
        """);
    GridMap map = new MapRasterizer(world, 0.1, 0.3).rasterize();
    int index = map.row(1.75) * map.width() + map.column(3.5);
    assertEquals(GridMap.OCCUPIED, map.cells()[index]);
    assertTrue(index > map.cells().length / 2);
    assertEquals(3.55, map.centreX(map.column(3.5001)), 1e-9);
  }

  @Test
  void theDemoIsFourteenByTenMetresAndAMargin() {
    GridMap map = new MapRasterizer(World.demo(), 0.05, 0.3).rasterize();
    assertEquals(304, map.width());
    assertEquals(224, map.height());
  }

  private static byte at(GridMap map, double x, double y) {
    return map.at(map.column(x), map.row(y));
  }
}
