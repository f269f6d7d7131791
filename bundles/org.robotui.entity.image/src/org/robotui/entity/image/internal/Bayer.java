package org.robotui.entity.image.internal;

import org.robotui.data.RawImage;

/**
 * The colours behind a Bayer filter, bilinear: a colour that a pixel did not measure is the mean of those neighbours that
 * did.
 */
final class Bayer implements RawPictures.Converter {
  private final RawImage raw;
  private final int redX;
  private final int redY;

  /** A filter whose red lies in column redX and row redY of each 2 x 2 block. */
  Bayer(RawImage raw, int redX, int redY) {
    this.raw = raw;
    this.redX = redX;
    this.redY = redY;
  }

  @Override
  public int rgb(int x, int y, int at) {
    boolean redColumn = (x & 1) == redX;
    boolean redRow = (y & 1) == redY;
    int here = value(x, y);
    if (redColumn && redRow) {
      return here << 16 | cross(x, y) << 8 | corners(x, y);
    }
    if (!redColumn && !redRow) {
      return corners(x, y) << 16 | cross(x, y) << 8 | here;
    }
    int beside = value(x - 1, y) + value(x + 1, y) >> 1;
    int above = value(x, y - 1) + value(x, y + 1) >> 1;
    return (redRow ? beside : above) << 16 | here << 8 | (redRow ? above : beside);
  }

  private int cross(int x, int y) {
    return value(x - 1, y) + value(x + 1, y) + value(x, y - 1) + value(x, y + 1) >> 2;
  }

  private int corners(int x, int y) {
    return value(x - 1, y - 1) + value(x + 1, y - 1) + value(x - 1, y + 1) + value(x + 1, y + 1) >> 2;
  }

  private int value(int x, int y) {
    return raw.pixels().unsigned(mirrored(y, raw.height()) * raw.step() + mirrored(x, raw.width()));
  }

  /** Beyond the edge the picture goes on mirrored, which keeps the colour of the filter. */
  private static int mirrored(int index, int size) {
    int inside = index < 0 ? -index : index >= size ? 2 * size - 2 - index : index;
    return Math.clamp(inside, 0, size - 1);
  }
}
