package org.robotui.sim.internal.camera;

/** A baked picture of a floor or a ceiling, with coarser versions of it so that distant parts do not flicker. */
final class Surface {
  private static final int LEVELS = 4;

  private final double originX;
  private final double originY;
  private final double resolution;
  private final int[] widths = new int[LEVELS];
  private final int[] heights = new int[LEVELS];
  private final int[][] levels = new int[LEVELS][];

  /** @param pixels of 0xrrggbb, row by row from the origin; kept, not copied */
  Surface(double originX, double originY, double resolution, int width, int height, int[] pixels) {
    this.originX = originX;
    this.originY = originY;
    this.resolution = resolution;
    widths[0] = width;
    heights[0] = height;
    levels[0] = pixels;
    for (int level = 1; level < LEVELS; level++) {
      halve(level);
    }
  }

  private void halve(int level) {
    int fineWidth = widths[level - 1];
    int width = fineWidth / 2;
    int height = heights[level - 1] / 2;
    int[] fine = levels[level - 1];
    int[] coarse = new int[width * height];
    for (int i = 0; i < coarse.length; i++) {
      int corner = 2 * (i / width) * fineWidth + 2 * (i % width);
      int lower = Rgb.mix(fine[corner], fine[corner + 1], 0.5);
      coarse[i] = Rgb.mix(lower, Rgb.mix(fine[corner + fineWidth], fine[corner + fineWidth + 1], 0.5), 0.5);
    }
    widths[level] = width;
    heights[level] = height;
    levels[level] = coarse;
  }

  /** The level whose pixels are about as large as a screen pixel that covers so many metres. */
  int levelFor(double metres) {
    int level = 0;
    for (double size = resolution * 1.5; level < LEVELS - 1 && size < metres; size *= 2) {
      level++;
    }
    return level;
  }

  int at(double x, double y, int level) {
    double scale = 1 / (resolution * (1 << level));
    int column = Math.clamp((int) ((x - originX) * scale), 0, widths[level] - 1);
    int row = Math.clamp((int) ((y - originY) * scale), 0, heights[level] - 1);
    return levels[level][row * widths[level] + column];
  }
}
