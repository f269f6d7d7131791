package org.robotui.entity.gridmap.internal.display;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.navigation.GridMap;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Texture;
import org.robotui.gl.shape.TriangleMesh;

/**
 * A map as tiles. A new map makes those tiles new whose cells changed; the others stay the same objects. A map of more
 * cells than {@link #MOST} is drawn coarser: of the cells that become one, the most occupied is shown, so that no
 * obstacle is lost.
 */
final class Tiles {
  /** Cells drawn at most; four bytes of colour and one of occupancy each. */
  static final long MOST = 32_000_000;

  private static final int EDGE = 512;

  private final Map<Key, Tile> tiles = new LinkedHashMap<>();
  private Optional<GridMap> drawn = Optional.empty();
  private Optional<Look> look = Optional.empty();
  private int coarse = 1;

  /** Which tile. */
  record Key(int column, int row) {}

  /** What colours cells. */
  record Look(String scheme, boolean unknown) {}

  /** A tile: its cells, to compare with, and what is drawn. */
  record Tile(byte[] cells, TriangleMesh mesh, Texture texture) {}

  /** Draws what changed. */
  Map<Key, Tile> update(GridMap map, Look wanted) {
    if (drawn.filter(d -> d == map).isEmpty() || look.filter(wanted::equals).isEmpty()) {
      boolean keep = look.filter(wanted::equals).isPresent() && drawn.filter(d -> sameGrid(d, map)).isPresent();
      draw(map, new Scheme(wanted.scheme(), wanted.unknown()), keep);
      drawn = Optional.of(map);
      look = Optional.of(wanted);
    }
    return tiles;
  }

  /** How many cells along an edge became one. */
  int coarse() {
    return coarse;
  }

  void clear() {
    tiles.clear();
    drawn = Optional.empty();
  }

  private void draw(GridMap map, Scheme scheme, boolean keep) {
    if (!keep) {
      tiles.clear();
      coarse = 1;
      while ((long) up(map.width(), coarse) * up(map.height(), coarse) > MOST) {
        coarse++;
      }
    }
    int width = up(map.width(), coarse);
    int height = up(map.height(), coarse);
    for (int row = 0; row < height; row += EDGE) {
      for (int column = 0; column < width; column += EDGE) {
        draw(map, scheme, column, row, Math.min(EDGE, width - column), Math.min(EDGE, height - row));
      }
    }
  }

  private void draw(GridMap map, Scheme scheme, int column, int row, int width, int height) {
    byte[] cells = coarse == 1 ? copy(map, column, row, width, height) : coarser(map, column, row, width, height);
    Key key = new Key(column / EDGE, row / EDGE);
    Tile before = tiles.get(key);
    if (before == null || !Arrays.equals(before.cells(), cells)) {
      TriangleMesh mesh = before == null ? mesh(map.resolution() * coarse, column, row, width, height) : before.mesh();
      tiles.put(key, new Tile(cells, mesh, new Texture(width, height, scheme.color(cells), false)));
    }
  }

  private static byte[] copy(GridMap map, int column, int row, int width, int height) {
    byte[] cells = new byte[width * height];
    for (int y = 0; y < height; y++) {
      map.cells().copyTo((row + y) * map.width() + column, cells, y * width, width);
    }
    return cells;
  }

  private byte[] coarser(GridMap map, int column, int row, int width, int height) {
    byte[] cells = new byte[width * height];
    Arrays.fill(cells, GridMap.UNKNOWN);
    for (int y = row * coarse; y < Math.min(map.height(), (row + height) * coarse); y++) {
      for (int x = column * coarse; x < Math.min(map.width(), (column + width) * coarse); x++) {
        int at = (y / coarse - row) * width + x / coarse - column;
        cells[at] = (byte) Math.max(cells[at], map.cell(x, y));
      }
    }
    return cells;
  }

  private static TriangleMesh mesh(double cell, int column, int row, int width, int height) {
    float left = (float) (column * cell);
    float low = (float) (row * cell);
    float right = (float) ((column + width) * cell);
    float high = (float) ((row + height) * cell);
    FloatBuffer xyz = FloatBuffer.wrap(new float[]{left, low, 0, right, low, 0, right, high, 0, left, high, 0});
    FloatBuffer uv = FloatBuffer.wrap(new float[]{0, 0, 1, 0, 1, 1, 0, 1});
    return new TriangleMesh(xyz, Optional.empty(), Optional.of(uv), Optional.empty(),
        IntBuffer.wrap(new int[]{0, 1, 2, 0, 2, 3}),
        Box3.around(xyz));
  }

  private static boolean sameGrid(GridMap a, GridMap b) {
    return a.width() == b.width() && a.height() == b.height() && a.resolution() == b.resolution();
  }

  private static int up(int cells, int coarse) {
    return (int) (((long) cells + coarse - 1) / coarse);
  }
}
