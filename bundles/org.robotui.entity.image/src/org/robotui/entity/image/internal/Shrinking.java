package org.robotui.entity.image.internal;

import java.util.Arrays;
import org.eclipse.swt.graphics.ImageData;

/** Blocks of pixels become one of their mean colour. */
public final class Shrinking {
  private Shrinking() {}

  /**
   * Shrinks. What is left at the right and lower edge belongs to the last blocks.
   *
   * @param source 8 bits of grey or 24 bits a pixel, rows without padding
   * @param factor edge of a block, at least 2
   * @return the small picture, at least one pixel
   */
  public static ImageData of(ImageData source, int factor) {
    int channels = source.depth / 8;
    int width = Math.max(1, source.width / factor);
    int height = Math.max(1, source.height / factor);
    byte[] target = new byte[width * height * channels];
    int[] sums = new int[width * channels];
    for (int y = 0; y < height; y++) {
      int bottom = y == height - 1 ? source.height : (y + 1) * factor;
      Arrays.fill(sums, 0);
      for (int row = y * factor; row < bottom; row++) {
        add(source, row, factor, sums, channels);
      }
      mean(source, sums, bottom - y * factor, factor, channels, target, y * width * channels);
    }
    return new ImageData(width, height, source.depth, source.palette, 1, target);
  }

  private static void add(ImageData source, int row, int factor, int[] sums, int channels) {
    byte[] data = source.data;
    int at = row * source.width * channels;
    int columns = sums.length / channels;
    for (int x = 0; x < columns; x++) {
      int count = x == columns - 1 ? source.width - x * factor : factor;
      if (channels == 1) {
        sums[x] += sum(data, at, count, 1);
      } else {
        sums[3 * x] += sum(data, at, count, 3);
        sums[3 * x + 1] += sum(data, at + 1, count, 3);
        sums[3 * x + 2] += sum(data, at + 2, count, 3);
      }
      at += count * channels;
    }
  }

  private static int sum(byte[] data, int from, int count, int step) {
    int sum = 0;
    for (int i = 0, at = from; i < count; i++, at += step) {
      sum += data[at] & 0xff;
    }
    return sum;
  }

  private static void mean(ImageData source, int[] sums, int rows, int factor, int channels, byte[] target, int at) {
    int columns = sums.length / channels;
    int last = rows * (source.width - (columns - 1) * factor);
    int count = rows * factor;
    for (int i = 0; i < sums.length; i++) {
      int pixels = i < sums.length - channels ? count : last;
      target[at + i] = (byte) ((sums[i] + pixels / 2) / pixels);
    }
  }
}
