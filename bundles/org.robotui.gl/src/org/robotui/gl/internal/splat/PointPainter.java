package org.robotui.gl.internal.splat;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.function.BooleanSupplier;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.PointSet.Style;

/** Writes the points of one set, by pieces that stay in the caches of the processor. */
public final class PointPainter {
  private static final int PIECE = 4096;
  private static final byte[] WHITE = {-1, -1, -1, -1};

  private final Splats splats;
  private final Brush brush;
  private final float[] xyz = new float[3 * PIECE];
  private final byte[] rgba = new byte[4 * PIECE];
  private final int[] reds;
  private final int[] greens;
  private final int[] blues;

  /**
   * Takes what it writes with.
   *
   * @param splats to write into
   * @param brush how
   */
  public PointPainter(Splats splats, Brush brush) {
    this.splats = splats;
    this.brush = brush;
    reds = brush.table(brush.tint().red(), brush.glow().red(), 16);
    greens = brush.table(brush.tint().green(), brush.glow().green(), 8);
    blues = brush.table(brush.tint().blue(), brush.glow().blue(), 0);
  }

  /**
   * Writes.
   *
   * @param points the set
   * @param every n-th of them
   * @param givenUp asked between pieces: whether the rest is wanted no more
   * @return how many there were to write
   */
  public int paint(PointSet points, int every, BooleanSupplier givenUp) {
    splats.use();
    int count = Math.ceilDiv(points.elements(), every);
    for (int first = 0; first < count && !givenUp.getAsBoolean(); first += PIECE) {
      int size = Math.min(PIECE, count - first);
      load(points, first, size, every);
      paintPiece(first, size, every);
    }
    return count;
  }

  private void load(PointSet points, int first, int size, int every) {
    FloatBuffer places = points.xyz();
    if (every == 1) {
      places.get(3 * first, xyz, 0, 3 * size);
    } else {
      for (int i = 0; i < size; i++) {
        places.get(3 * every * (first + i), xyz, 3 * i, 3);
      }
    }
    points.rgba().ifPresentOrElse(colors -> loadColors(colors, first, size, every), this::loadWhite);
  }

  private void loadColors(ByteBuffer colors, int first, int size, int every) {
    if (every == 1) {
      colors.get(4 * first, rgba, 0, 4 * size);
    } else {
      for (int i = 0; i < size; i++) {
        colors.get(4 * every * (first + i), rgba, 4 * i, 4);
      }
    }
  }

  private void loadWhite() {
    if (rgba[0] == 0) {
      for (int i = 0; i < PIECE; i++) {
        System.arraycopy(WHITE, 0, rgba, 4 * i, WHITE.length);
      }
    }
  }

  /** What is no finite number fails a comparison, and is left out as what lies outside. */
  private void paintPiece(int first, int size, int every) {
    float[] m = brush.clipFromShape();
    float halfWidth = splats.width() / 2f;
    float halfHeight = splats.height() / 2f;
    float middle = (brush.far() + brush.near()) / 2;
    float half = (brush.far() - brush.near()) / 2;
    boolean picking = splats.picking();
    for (int i = 0; i < size; i++) {
      float x = xyz[3 * i];
      float y = xyz[3 * i + 1];
      float z = xyz[3 * i + 2];
      float w = m[3] * x + m[7] * y + m[11] * z + m[15];
      float deep = m[2] * x + m[6] * y + m[10] * z + m[14];
      float across = m[0] * x + m[4] * y + m[8] * z + m[12];
      float down = m[1] * x + m[5] * y + m[9] * z + m[13];
      if (deep >= -w && deep <= w && across >= -w && across < w && down >= -w && down < w) {
        float near = 1 / w;
        int value = picking ? every * (first + i) : color(4 * i);
        // With what rounding may leave below 0, the bits would be those of a negative number.
        float depth = Math.max(0, middle + half * deep * near);
        dot((across * near + 1) * halfWidth, (down * near + 1) * halfHeight, near, Splats.cell(depth, value));
      }
    }
  }

  private int color(int at) {
    return reds[rgba[at] & 0xff] | greens[rgba[at + 1] & 0xff] | blues[rgba[at + 2] & 0xff];
  }

  private void dot(float x, float y, float near, long cell) {
    float edge = brush.pixels() > 0 ? brush.pixels() : Math.max(1, brush.reach() * near);
    int left = Math.max(0, Splats.firstPixel(x - edge / 2));
    int right = Math.min(splats.width(), Splats.firstPixel(x + edge / 2));
    int top = Math.max(0, Splats.firstPixel(y - edge / 2));
    int bottom = Math.min(splats.height(), Splats.firstPixel(y + edge / 2));
    if (brush.style() == Style.DISC && edge > 1) {
      disc(left, top, right, bottom, x, y, edge / 2, cell);
    } else {
      splats.put(left, top, right, bottom, cell, brush.part());
    }
  }

  /** All pixels whose middle is in it. */
  private void disc(int left, int top, int right, int bottom, float x, float y, float radius, long cell) {
    for (int row = top; row < bottom; row++) {
      for (int column = left; column < right; column++) {
        float dx = column + 0.5f - x;
        float dy = row + 0.5f - y;
        if (dx * dx + dy * dy <= radius * radius) {
          splats.put(row * splats.width() + column, cell, brush.part());
        }
      }
    }
  }
}
