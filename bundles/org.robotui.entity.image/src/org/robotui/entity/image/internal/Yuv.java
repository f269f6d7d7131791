package org.robotui.entity.image.internal;

import org.eclipse.swt.graphics.ImageData;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;

/** The colours of luminance and chroma (BT.601), two pixels of which share their chroma. */
final class Yuv {
  private static final int NEUTRAL = 128;
  private static final int BITS = 16;
  private static final int HALF = 1 << BITS - 1;
  private static final int RED_V = (int) Math.round(1.402 * (1 << BITS));
  private static final int GREEN_U = (int) Math.round(0.344136 * (1 << BITS));
  private static final int GREEN_V = (int) Math.round(0.714136 * (1 << BITS));
  private static final int BLUE_U = (int) Math.round(1.772 * (1 << BITS));

  private Yuv() {}

  static ImageData decode(RawImage raw) {
    int luminance = raw.encoding() == PixelEncoding.UYVY ? 1 : 0;
    int chroma = 1 - luminance;
    Samples samples = new Samples(raw);
    int[] row = new int[samples.perRow()];
    Raster raster = new Raster(raw.width(), raw.height());
    for (int y = 0; y < raw.height(); y++) {
      samples.whole(y, row, 0);
      for (int x = 0; x < raw.width(); x++) {
        int even = 2 * (x & ~1);
        int u = row[even + chroma] - NEUTRAL;
        // The last pixel of an odd row has no second chroma.
        int v = even + 2 < row.length ? row[even + 2 + chroma] - NEUTRAL : 0;
        int light = (row[2 * x + luminance] << BITS) + HALF;
        raster.put(channel(light + RED_V * v), channel(light - GREEN_U * u - GREEN_V * v), channel(light + BLUE_U * u));
      }
    }
    return raster.data();
  }

  private static int channel(int scaled) {
    return Math.max(0, Math.min(255, scaled >> BITS));
  }
}
