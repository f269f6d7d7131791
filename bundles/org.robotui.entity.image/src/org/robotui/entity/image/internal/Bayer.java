package org.robotui.entity.image.internal;

import org.eclipse.swt.graphics.ImageData;
import org.robotui.data.image.RawImage;

/**
 * The colours behind a Bayer filter, bilinear: a colour that a pixel did not measure is the mean of those neighbours
 * that did. Beyond the edge the picture goes on mirrored, which keeps the colours of the filter.
 */
final class Bayer {
  private static final int SHOWN_BITS = 8;

  private final RawImage raw;
  private final Samples samples;
  private final int redX;
  private final int redY;
  private final int shift;
  private int[] above;
  private int[] here;
  private int[] below;

  private Bayer(RawImage raw, int bits) {
    // The letters after the first underscore are the upper left 2 x 2 block.
    int red = raw.encoding().name().indexOf('R', "BAYER_".length()) - "BAYER_".length();
    this.raw = raw;
    this.samples = new Samples(raw);
    this.redX = red & 1;
    this.redY = red >> 1;
    this.shift = bits - SHOWN_BITS;
    this.above = new int[raw.width() + 2];
    this.here = new int[raw.width() + 2];
    this.below = new int[raw.width() + 2];
  }

  static ImageData decode(RawImage raw, Levels levels) {
    return new Bayer(raw, levels.bits(Wholes.largest(raw))).pixels();
  }

  private ImageData pixels() {
    Raster raster = new Raster(raw.width(), raw.height());
    read(-1, above);
    read(0, here);
    for (int y = 0; y < raw.height(); y++) {
      read(y + 1, below);
      if ((y & 1) == redY) {
        redRow(raster);
      } else {
        blueRow(raster);
      }
      int[] free = above;
      above = here;
      here = below;
      below = free;
    }
    return raster.data();
  }

  private void redRow(Raster raster) {
    for (int i = 1; i <= raw.width(); i++) {
      if ((i - 1 & 1) == redX) {
        raster.put(here[i] >> shift, cross(i), corners(i));
      } else {
        raster.put(beside(i), here[i] >> shift, upright(i));
      }
    }
  }

  private void blueRow(Raster raster) {
    for (int i = 1; i <= raw.width(); i++) {
      if ((i - 1 & 1) == redX) {
        raster.put(upright(i), here[i] >> shift, beside(i));
      } else {
        raster.put(corners(i), cross(i), here[i] >> shift);
      }
    }
  }

  private int beside(int i) {
    return here[i - 1] + here[i + 1] >> shift + 1;
  }

  private int upright(int i) {
    return above[i] + below[i] >> shift + 1;
  }

  private int cross(int i) {
    return here[i - 1] + here[i + 1] + above[i] + below[i] >> shift + 2;
  }

  private int corners(int i) {
    return above[i - 1] + above[i + 1] + below[i - 1] + below[i + 1] >> shift + 2;
  }

  private void read(int y, int[] into) {
    int width = raw.width();
    samples.whole(mirrored(y, raw.height()), into, 1);
    into[0] = into[1 + mirrored(-1, width)];
    into[width + 1] = into[1 + mirrored(width, width)];
  }

  private static int mirrored(int index, int size) {
    int inside = index < 0 ? -index : index >= size ? 2 * size - 2 - index : index;
    return Math.clamp(inside, 0, size - 1);
  }
}
