package org.robotui.gl.internal.splat;

import org.robotui.gl.shape.PointSet.Style;
import org.robotui.gl.shape.Rgba;

/**
 * How the points of one set are written.
 *
 * @param clipFromShape sixteen numbers, column by column
 * @param pixels edge of a point; 0 where it depends on the distance
 * @param reach pixels of a point at a distance of one, where it does
 * @param style of a point
 * @param tint multiplies the colours
 * @param glow mixed into them, as much as its alpha says
 * @param near depth of the nearest
 * @param far depth of the farthest
 * @param part id of the part
 */
public record Brush(float[] clipFromShape, int pixels, float reach, Style style, Rgba tint, Rgba glow, float near,
    float far, int part) {
  private static final int CHANNEL = 256;
  private static final int MOST = 255;

  /** What becomes of each value of a channel, moved to its place in the pixel. */
  int[] table(float tint, float glow, int shift) {
    int[] table = new int[CHANNEL];
    for (int i = 0; i < CHANNEL; i++) {
      float mixed = i * tint * (1 - this.glow.alpha()) + MOST * glow * this.glow.alpha();
      table[i] = Math.round(mixed) << shift;
    }
    return table;
  }
}
