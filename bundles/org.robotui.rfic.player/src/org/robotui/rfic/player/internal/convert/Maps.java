package org.robotui.rfic.player.internal.convert;

import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.navigation.GridMap;
import org.robotui.net.packed.Zlib;
import org.robotui.player.interfaces.PlayerMap;

/** Grids of cells, put together from tiles. */
public final class Maps {
  /** The most cells of a map; a larger one is refused before anything is kept for it. */
  public static final long MOST_CELLS = 1L << 26;
  /** The side of a tile that is asked for, in cells. */
  public static final int TILE = 640;
  private static final int CERTAIN = 100;

  private Maps() {}

  /** Checks a map before its tiles are fetched. */
  public static void check(PlayerMap.Info info) {
    if (!(info.scale() > 0) || !Float.isFinite(info.scale())) {
      throw new IllegalArgumentException("scale: must be positive, is " + info.scale());
    }
    if (info.width() > MOST_CELLS || info.height() > MOST_CELLS || info.width() * info.height() > MOST_CELLS) {
      throw new IllegalArgumentException(
          "a map of " + info.width() + " x " + info.height() + " cells is larger than " + MOST_CELLS + " cells");
    }
  }

  public static GridMap of(PlayerMap.Info info, byte[] cells, FrameId frame) {
    return new GridMap(frame, info.scale(), (int) info.width(), (int) info.height(), Poses.of(info.origin()),
        Bytes.wrap(cells, 0, cells.length));
  }

  /** Writes a tile into the cells of a map. */
  public static void put(PlayerMap.Tile tile, PlayerMap.Info info, byte[] cells) {
    if (tile.column() + tile.width() > info.width() || tile.row() + tile.height() > info.height()) {
      throw new IllegalArgumentException(
          "a tile of " + tile.width() + " x " + tile.height() + " cells at " + tile.column() + ", " + tile.row()
              + " reaches beyond the map of " + info.width() + " x " + info.height());
    }
    int width = (int) tile.width();
    byte[] packed = Zlib.inflate(tile.cells(), width * (int) tile.height());
    int range = tile.range() > 0 ? tile.range() : 1;
    for (int row = 0; row < tile.height(); row++) {
      int to = (int) ((tile.row() + row) * info.width() + tile.column());
      for (int column = 0; column < width; column++) {
        cells[to + column] = occupancy(packed[row * width + column], range);
      }
    }
  }

  /** Player says -range for free, 0 for unknown, range for occupied. */
  static byte occupancy(int cell, int range) {
    int within = Math.clamp(cell, -range, range);
    return within == 0 ? GridMap.UNKNOWN : (byte) (CERTAIN * (within + range) / (2 * range));
  }
}
