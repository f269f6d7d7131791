package org.robotui.sim.internal.nav;

import java.util.Arrays;
import org.robotui.sim.internal.world.GridMap;

/** How far each cell of a map is from the next obstacle, up to a limit. Immutable. */
public final class Clearance {
  public static final double LIMIT = 1.0;

  private final GridMap map;
  private final float[] metres;

  public Clearance(GridMap map) {
    this.map = map;
    metres = new float[map.width() * map.height()];
    Arrays.fill(metres, (float) LIMIT);
    int reach = (int) Math.ceil(LIMIT / map.resolution());
    for (int i = 0; i < metres.length; i++) {
      if (isEdge(i % map.width(), i / map.width())) {
        stamp(i % map.width(), i / map.width(), reach);
      }
    }
  }

  private boolean isBlocked(int column, int row) {
    return map.at(column, row) != GridMap.FREE;
  }

  private boolean isEdge(int column, int row) {
    boolean surrounded = isBlocked(column - 1, row)
        && isBlocked(column + 1, row)
        && isBlocked(column, row - 1)
        && isBlocked(column, row + 1);
    return isBlocked(column, row) && !surrounded;
  }

  private void stamp(int column, int row, int reach) {
    for (int r = Math.max(0, row - reach); r <= Math.min(map.height() - 1, row + reach); r++) {
      for (int c = Math.max(0, column - reach); c <= Math.min(map.width() - 1, column + reach); c++) {
        int i = r * map.width() + c;
        float distance = (float) (Math.hypot(c - column, r - row) * map.resolution());
        metres[i] = isBlocked(c, r) ? 0 : Math.min(metres[i], distance);
      }
    }
  }

  public GridMap map() {
    return map;
  }

  /** Metres from the cell's centre to the nearest obstacle or unknown cell; 0 in one and outside of the map. */
  public double at(int column, int row) {
    boolean inside = column >= 0 && column < map.width() && row >= 0 && row < map.height();
    return inside && !isBlocked(column, row) ? metres[row * map.width() + column] : 0;
  }

  public double atPoint(double x, double y) {
    return at(map.column(x), map.row(y));
  }
}
