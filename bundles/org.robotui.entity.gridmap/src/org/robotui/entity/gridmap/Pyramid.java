package org.robotui.entity.gridmap;

import java.util.ArrayList;
import java.util.List;
import org.robotui.data.navigation.GridMap;

/**
 * A map and coarser ones made of it.
 *
 * @param map the map
 * @param levels the map itself first, each next half as fine
 */
record Pyramid(GridMap map, List<Level> levels) {
  private static final int SMALL_ENOUGH = 256;

  static Pyramid of(GridMap map) {
    List<Level> levels = new ArrayList<>();
    Level level = new Level(1, map.width(), map.height(), map.cells());
    levels.add(level);
    while (Math.max(level.width(), level.height()) > SMALL_ENOUGH) {
      level = level.coarser();
      levels.add(level);
    }
    return new Pyramid(map, List.copyOf(levels));
  }

  /** The finest level whose cells are at least a pixel wide, or the coarsest. */
  int suited(double pixelsPerCell) {
    int index = 0;
    double pixels = pixelsPerCell;
    while (pixels < 1 && index < levels.size() - 1) {
      pixels *= 2;
      index++;
    }
    return index;
  }
}
