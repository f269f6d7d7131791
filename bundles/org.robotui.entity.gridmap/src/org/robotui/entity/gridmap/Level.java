package org.robotui.entity.gridmap;

import org.robotui.data.array.Bytes;

/**
 * One level of a pyramid.
 *
 * @param factor how many cells of the map one of its cells is wide
 * @param width cells along x
 * @param height cells along y
 * @param cells row by row from the origin
 */
record Level(int factor, int width, int height, Bytes cells) {
  /** The next coarser level. What is occupied stays so, or thin walls would fade away. */
  Level coarser() {
    int halfWidth = (width + 1) / 2;
    int halfHeight = (height + 1) / 2;
    byte[] coarse = new byte[halfWidth * halfHeight];
    byte[] row = new byte[width];
    byte[] above = new byte[width];
    for (int y = 0; y < halfHeight; y++) {
      cells.copyTo(2 * y * width, row, 0, width);
      cells.copyTo(Math.min(2 * y + 1, height - 1) * width, above, 0, width);
      for (int x = 0; x < halfWidth; x++) {
        int right = Math.min(2 * x + 1, width - 1);
        int lower = Math.max(row[2 * x], row[right]);
        int upper = Math.max(above[2 * x], above[right]);
        coarse[y * halfWidth + x] = (byte) Math.max(lower, upper);
      }
    }
    return new Level(2 * factor, halfWidth, halfHeight, Bytes.wrap(coarse, 0, coarse.length));
  }
}
