package org.robotui.entity.gridmap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.navigation.GridMap;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.scene.Bounds;

class PyramidTest {
  private static final FrameId FRAME = new FrameId("Keira", "map");

  @Test
  void thinWallsSurviveAndUnknownStaysUnknown() {
    byte[] cells = new byte[600 * 5];
    Arrays.fill(cells, GridMap.UNKNOWN);
    cells[2 * 600 + 301] = 100;
    cells[4 * 600 + 599] = 0;
    Pyramid pyramid = Pyramid.of(map(600, 5, cells));
    Level coarsest = pyramid.levels().getLast();
    assertEquals(4, coarsest.factor());
    assertEquals(150, coarsest.width());
    assertEquals(2, coarsest.height());
    assertEquals(100, coarsest.cells().get(301 / 4));
    assertEquals(0, coarsest.cells().get(150 + 149));
    assertEquals(GridMap.UNKNOWN, coarsest.cells().get(0));
  }

  @Test
  void theFinestLevelIsTheMapItselfWithoutACopy() {
    GridMap map = map(300, 300, new byte[300 * 300]);
    assertSame(map.cells(), Pyramid.of(map).levels().getFirst().cells());
  }

  @Test
  void theLevelSuitsTheZoom() {
    Pyramid pyramid = Pyramid.of(map(2048, 16, new byte[2048 * 16]));
    assertEquals(4, pyramid.levels().size());
    assertEquals(0, pyramid.suited(3));
    assertEquals(1, pyramid.suited(0.6));
    assertEquals(2, pyramid.suited(0.3));
    assertEquals(3, pyramid.suited(0.0001));
  }

  @Test
  void onlyTilesInTheWindowAreSeen() {
    Pyramid pyramid = Pyramid.of(map(2048, 600, new byte[2048 * 600]));
    TileRange range = TileRange.seen(pyramid, 0, RigidTransform.planar(10, 0, 0), new Bounds(36, -5, 37, 3));
    assertEquals(new TileRange(1, 1, 0, 0), range);
    TileRange none = TileRange.seen(pyramid, 0, RigidTransform.IDENTITY, new Bounds(-30, -30, -20, -20));
    assertTrue(none.lastColumn() < none.firstColumn());
  }

  @Test
  void anEmptyMapIsNoProblem() {
    Pyramid pyramid = Pyramid.of(map(0, 0, new byte[0]));
    TileRange range = TileRange.seen(pyramid, 0, RigidTransform.IDENTITY, new Bounds(-1, -1, 1, 1));
    assertTrue(range.lastRow() < range.firstRow());
  }

  private static GridMap map(int width, int height, byte[] cells) {
    return new GridMap(FRAME, 0.1, width, height, RigidTransform.IDENTITY, Bytes.of(cells));
  }
}
