package org.robotui.entity.gridmap;

import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.PaletteData;
import org.eclipse.swt.graphics.RGB;
import org.robotui.ui.Palette;
import org.robotui.ui.Role;

/**
 * Gives cells the colours of a theme: from floor, which lets a grid below shine through, to wall; unknown ones are
 * transparent.
 */
final class Tint {
  private static final int FULL = 100;
  private static final int BYTES_PER_PIXEL = 4;
  private static final int FLOOR_ALPHA = 115;
  private static final int OPAQUE = 255;

  private final byte[] red = new byte[FULL + 1];
  private final byte[] green = new byte[FULL + 1];
  private final byte[] blue = new byte[FULL + 1];
  private final byte[] alpha = new byte[FULL + 1];

  Tint(Palette palette) {
    for (int i = 0; i <= FULL; i++) {
      RGB rgb = Palette.mix(palette.rgb(Role.WALL), palette.rgb(Role.FLOOR), i / (double) FULL);
      red[i] = (byte) rgb.red;
      green[i] = (byte) rgb.green;
      blue[i] = (byte) rgb.blue;
      alpha[i] = (byte) (FLOOR_ALPHA + (OPAQUE - FLOOR_ALPHA) * i / FULL);
    }
  }

  /** Colours a part of a level; the first row of the image is the lowest of the part. */
  ImageData image(Level level, int left, int low, int width, int height) {
    ImageData image = new ImageData(width, height, 32, new PaletteData(0xff0000, 0xff00, 0xff));
    image.alphaData = new byte[width * height];
    byte[] row = new byte[width];
    for (int y = 0; y < height; y++) {
      level.cells().copyTo((low + y) * level.width() + left, row, 0, width);
      for (int x = 0; x < width; x++) {
        if (row[x] >= 0) {
          put(image, y * image.bytesPerLine + x * BYTES_PER_PIXEL, Math.min(row[x], FULL));
          image.alphaData[y * width + x] = alpha[Math.min(row[x], FULL)];
        }
      }
    }
    return image;
  }

  private void put(ImageData image, int at, int occupancy) {
    image.data[at + 1] = red[occupancy];
    image.data[at + 2] = green[occupancy];
    image.data[at + 3] = blue[occupancy];
  }
}
