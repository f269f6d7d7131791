package org.robotui.entity.gridmap.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.data.array.Bytes;
import org.robotui.data.navigation.GridMap;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Texture;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

class GridMapDisplayTest {
  private final DisplayProbe probe = new DisplayProbe(new GridMapType());

  @Test
  void theFirstRowOfCellsLiesAtTheOrigin() {
    Part part = probe.parts(map(2, 2, (byte) 100, (byte) 0, (byte) -1, (byte) 0)).getFirst();
    assertEquals(10, part.bounds().orElseThrow().low().x(), 1e-9);
    assertEquals(11, part.bounds().orElseThrow().high().x(), 1e-9);
    assertEquals(0x5d86b8ff, texture(part).rgba().getInt(0));
    assertEquals(0, texture(part).rgba().getInt(8), "unknown is not painted");
    assertEquals("100 %", part.describer().describe(0, new Vector3(0.1, 0.1, 0)).entries().get(1).value());
    assertEquals("unknown", part.describer().describe(0, new Vector3(0.1, 0.6, 0)).entries().get(1).value());
    assertEquals("grid map", part.describer().describe(0, new Vector3(-0.1, 0.6, 0)).title());
  }

  @Test
  void onlyTilesWhoseCellsChangedAreNew() {
    byte[] cells = new byte[1200 * 700];
    List<Part> first = probe.parts(map(1200, 700, cells));
    assertEquals(6, first.size());
    cells[0] = 50;
    List<Part> second = probe.parts(map(1200, 700, cells));
    assertNotSame(texture(first.getFirst()), texture(second.getFirst()));
    assertSame(first.getFirst().shape(), second.getFirst().shape());
    for (int i = 1; i < 6; i++) {
      assertSame(texture(first.get(i)), texture(second.get(i)));
    }
    assertSame(texture(second.getFirst()), texture(probe.parts().getFirst()));
  }

  @Test
  void schemesColour() {
    GridMap map = map(4, 1, (byte) 0, (byte) 99, (byte) 100, (byte) 50);
    Texture costs = texture(probe.set("scheme", "costmap").parts(map).getFirst());
    assertEquals(List.of(0, 0x00ffffff, 0xff00ffff),
        List.of(costs.rgba().getInt(0), costs.rgba().getInt(4), costs.rgba().getInt(8)));
    Texture raw = texture(probe.set("scheme", "raw").parts().getFirst());
    assertEquals(0x323232ff, raw.rgba().getInt(12));
    assertEquals(0xff, raw.rgba().getInt(0));
  }

  @Test
  void aMapWithoutCellsAndOneOfStrangeValuesAreTaken() {
    assertTrue(probe.parts(map(0, 0)).isEmpty());
    assertTrue(probe.parts(map(1000, 0)).isEmpty());
    assertEquals(1, probe.parts(map(2, 1, (byte) -128, (byte) 127)).size());
  }

  @Test
  void aHugeMapIsDrawnCoarserAndLosesNoObstacle() {
    byte[] cells = new byte[8000 * 8000];
    cells[7999 * 8000 + 7999] = 100;
    DisplayResult result = probe.tick(map(8000, 8000, cells));
    assertTrue(result.status() instanceof DisplayStatus.Partly, result.status().toString());
    Texture last = texture(result.parts().getLast());
    assertEquals(0x5d86b8ff, last.rgba().getInt(last.rgba().remaining() - 4));
    long drawn = result.parts().stream().mapToLong(p -> (long) texture(p).width() * texture(p).height()).sum();
    assertTrue(drawn <= Tiles.MOST, "" + drawn);
    assertEquals(8000 * 0.5 + 10, result.parts().getLast().bounds().orElseThrow().high().x(), 1);
  }

  @Test
  void anotherSizeIsAnotherMap() {
    probe.tick(map(1200, 700, new byte[1200 * 700]));
    assertEquals(1, probe.parts(map(2, 2, new byte[4])).size());
    probe.close();
  }

  private static Texture texture(Part part) {
    return part.material().texture().orElseThrow();
  }

  private static GridMap map(int width, int height, byte... cells) {
    return new GridMap(FakePlaces.frame("map"), 0.5, width, height, RigidTransform.planar(10, 0, 0), Bytes.of(cells));
  }
}
