package org.robotui.gl.internal.text;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import org.robotui.gl.internal.text.Strokes.Glyph;

/**
 * The glyphs as one picture of distances: each pixel says how far the nearest line is, so that letters are sharp at
 * every size and can have a rim. Computed once a context, in some milliseconds.
 */
final class Glyphs {
  /** Pixels of a cell, which holds one glyph. */
  static final int CELL = 40;
  /** Cells of a row. */
  static final int COLUMNS = 16;
  /** Pixels of one step of the grid of {@link Strokes}. */
  static final float STEP = 3.6f;
  /** Pixels from the corner of a cell to the origin of its glyph. */
  static final float MARGIN_X = 6;
  static final float MARGIN_Y = 11;
  /** Pixels of distance at which the picture's values end. */
  static final float REACH = 6;

  private static final int MOST = 255;

  private final Map<Integer, Integer> cells = new HashMap<>();
  private final int rows;
  private final ByteBuffer distances;

  Glyphs() {
    Map<Integer, Glyph> all = Strokes.all();
    rows = Math.ceilDiv(all.size(), COLUMNS);
    distances = ByteBuffer.allocateDirect(width() * height());
    all.keySet().stream().sorted().forEach(character -> {
      int cell = cells.size();
      cells.put(character, cell);
      draw(all.get(character), cell % COLUMNS * CELL, cell / COLUMNS * CELL);
    });
  }

  int width() {
    return COLUMNS * CELL;
  }

  int height() {
    return rows * CELL;
  }

  /** A byte a pixel: 255 on a line, 0 at {@link #REACH} pixels and beyond. */
  ByteBuffer distances() {
    return distances;
  }

  /** The cell of a character: counted by rows. */
  int cell(int character) {
    return cells.getOrDefault(character, cells.get(0));
  }

  private void draw(Glyph glyph, int left, int low) {
    for (int y = 0; y < CELL; y++) {
      for (int x = 0; x < CELL; x++) {
        double distance = distance(glyph, (x + 0.5f - MARGIN_X) / STEP, (y + 0.5f - MARGIN_Y) / STEP) * STEP;
        distances.put((low + y) * width() + left + x, (byte) Math.round(MOST * Math.max(0, 1 - distance / REACH)));
      }
    }
  }

  private static double distance(Glyph glyph, float x, float y) {
    double least = CELL;
    for (float[] line : glyph.lines()) {
      for (int i = 0; i + 3 < line.length; i += 2) {
        least = Math.min(least, distance(x, y, line[i], line[i + 1], line[i + 2], line[i + 3]));
      }
    }
    return least;
  }

  private static double distance(float x, float y, float fromX, float fromY, float toX, float toY) {
    float alongX = toX - fromX;
    float alongY = toY - fromY;
    float square = alongX * alongX + alongY * alongY;
    float t = square == 0 ? 0 : Math.clamp(((x - fromX) * alongX + (y - fromY) * alongY) / square, 0, 1);
    return Math.hypot(x - fromX - t * alongX, y - fromY - t * alongY);
  }
}
