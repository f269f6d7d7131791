package org.robotui.entity.image.internal;

import org.robotui.data.image.RawImage;

/** Looks over pictures of unsigned numbers. */
final class Wholes {
  private static final int ROWS = 64;

  private Wholes() {}

  /** About the largest number, from some of the rows. */
  static int largest(RawImage raw) {
    Samples samples = new Samples(raw);
    int[] row = new int[samples.perRow()];
    int bits = 0;
    // An odd step meets both kinds of rows of a Bayer filter.
    int step = raw.height() / ROWS | 1;
    for (int y = 0; y < raw.height(); y += step) {
      samples.whole(y, row, 0);
      for (int number : row) {
        bits |= number;
      }
    }
    return bits;
  }
}
