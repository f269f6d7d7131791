package org.robotui.entity.image.internal;

import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.PaletteData;

/** Collects pixels from the upper left to the lower right. */
final class Raster {
  static final PaletteData RGB = new PaletteData(0xff0000, 0xff00, 0xff);
  static final int DEPTH = 24;
  static final int CHANNELS = 3;

  private final int width;
  private final int height;
  private final byte[] bytes;
  private int at;

  Raster(int width, int height) {
    this.width = width;
    this.height = height;
    this.bytes = new byte[width * height * CHANNELS];
  }

  void put(int rgb) {
    bytes[at++] = (byte) (rgb >> 16);
    bytes[at++] = (byte) (rgb >> 8);
    bytes[at++] = (byte) rgb;
  }

  void put(int red, int green, int blue) {
    bytes[at++] = (byte) red;
    bytes[at++] = (byte) green;
    bytes[at++] = (byte) blue;
  }

  ImageData data() {
    return new ImageData(width, height, DEPTH, RGB, 1, bytes);
  }
}
