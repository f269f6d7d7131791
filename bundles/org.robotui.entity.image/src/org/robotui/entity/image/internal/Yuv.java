package org.robotui.entity.image.internal;

import org.robotui.data.RawImage;

/** The colours of luminance and chroma (BT.601), two pixels of which share their chroma. */
final class Yuv implements RawPictures.Converter {
  private static final int PAIR = 4;
  private static final int NEUTRAL = 128;

  private final RawImage raw;
  private final int luminance;
  private final int chroma;

  /** With the place of luminance and of chroma within a pixel of two bytes. */
  Yuv(RawImage raw, int luminance, int chroma) {
    this.raw = raw;
    this.luminance = luminance;
    this.chroma = chroma;
  }

  @Override
  public int rgb(int x, int y, int at) {
    int row = y * raw.step();
    int first = row + (x >> 1) * PAIR;
    // The last pixel of an odd row has no second chroma.
    boolean whole = (x | 1) < raw.width();
    int u = raw.pixels().unsigned(first + chroma) - NEUTRAL;
    int v = whole ? raw.pixels().unsigned(first + 2 + chroma) - NEUTRAL : 0;
    int light = raw.pixels().unsigned(at + luminance);
    return channel(light + 1.402 * v) << 16 | channel(light - 0.344136 * u - 0.714136 * v) << 8 | channel(light + 1.772 * u);
  }

  private static int channel(double value) {
    return (int) Math.clamp(Math.round(value), 0L, 255L);
  }
}
