package org.robotui.entity.gridmap.internal.display;

import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.array.Bytes;
import org.robotui.data.navigation.GridMap;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Eye;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

/** How maps look. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class GridMapPicturesTest {
  @AutoClose
  private static final ScenePictures PICTURES = new ScenePictures();

  private static final Eye ABOVE = ScenePictures.eye(new Vector3(1.6, -0.9, 2.8), new Vector3(1.6, 0.9, 0));

  private final DisplayProbe probe = new DisplayProbe(new GridMapType());

  /**
   * An L of walls along x and y from the origin, unknown at the far corner, and a row of costs from 0 to 100 beyond the
   * wall.
   */
  private static GridMap room(RigidTransform origin) {
    int width = 30;
    int height = 20;
    byte[] cells = new byte[width * height];
    for (int row = 0; row < height; row++) {
      for (int column = 0; column < width; column++) {
        boolean wall = row < 2 || column < 2 && row < 12;
        boolean unknown = row > 14 && column > 20;
        int cost = row == 8 && column > 5 && column < 27 ? 5 * (column - 6) : 0;
        cells[row * width + column] = (byte) (wall ? 100 : unknown ? GridMap.UNKNOWN : cost);
      }
    }
    return new GridMap(FakePlaces.frame("map"), 0.1, width, height, origin, Bytes.of(cells));
  }

  private void show(String name, GridMap map) {
    PICTURES.assertLike(GridMapPicturesTest.class, name,
        ScenePictures.request(ScenePictures.withAxes(probe.parts(map), 1), ABOVE));
    probe.close();
  }

  @Test
  void aMapBeginsAtItsOriginAndGoesAlongXFirst() {
    show("map", room(RigidTransform.IDENTITY));
  }

  @Test
  void whatIsUnknownIsPaintedWhereAskedFor() {
    probe.set("unknown", true).set("opacity", 1.0);
    show("unknown", room(RigidTransform.IDENTITY));
  }

  @Test
  void aCostmapGoesFromBlueToRed() {
    probe.set("scheme", "costmap");
    show("costmap", room(RigidTransform.IDENTITY));
  }

  @Test
  void theOriginTurnsTheMapAndTheFrameCarriesIt() {
    probe.set("height", 0.5);
    show("turned", room(RigidTransform.planar(2, 0, Math.PI / 4)));
  }
}
