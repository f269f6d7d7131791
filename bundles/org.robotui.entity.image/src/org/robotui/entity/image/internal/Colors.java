package org.robotui.entity.image.internal;

import java.util.stream.IntStream;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.PaletteData;
import org.eclipse.swt.graphics.RGB;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.entity.image.Span;

/** Pictures whose numbers are colours already. Opacity is left aside. */
final class Colors {
  private static final PaletteData BGR = new PaletteData(0xff, 0xff00, 0xff0000);
  private static final int GREY_DEPTH = 8;
  private static final int BRIGHTEST = 255;
  private static final int SHOWN_BITS = 8;
  private static final int SAMPLED = 16_384;

  private Colors() {}

  static PaletteData greys() {
    return new PaletteData(
        IntStream.rangeClosed(0, BRIGHTEST).mapToObj(level -> new RGB(level, level, level)).toArray(RGB[]::new));
  }

  static PaletteData bgr() {
    return BGR;
  }

  /** The bytes lie as the window wants them: whole rows are copied. */
  static ImageData packed(RawImage raw) {
    int row = raw.width() * raw.encoding().bytesPerPixel();
    byte[] target = new byte[row * raw.height()];
    for (int y = 0; y < raw.height(); y++) {
      raw.pixels().copyTo(y * raw.step(), target, y * row, row);
    }
    if (raw.encoding().channels() == 1) {
      return new ImageData(raw.width(), raw.height(), GREY_DEPTH, greys(), 1, target);
    }
    return new ImageData(raw.width(), raw.height(), Raster.DEPTH, redFirst(raw.encoding()) ? Raster.RGB : BGR, 1,
        target);
  }

  /** Unsigned numbers of 8 or 16 bits, three or four a pixel. */
  static ImageData whole(RawImage raw, Levels levels) {
    int shift = raw.encoding().sample() == PixelEncoding.Sample.U8 ? 0 : levels.bits(Wholes.largest(raw)) - SHOWN_BITS;
    Samples samples = new Samples(raw);
    int[] row = new int[samples.perRow()];
    int red = redFirst(raw.encoding()) ? 0 : 2;
    int channels = raw.encoding().channels();
    Raster raster = new Raster(raw.width(), raw.height());
    for (int y = 0; y < raw.height(); y++) {
      samples.whole(y, row, 0);
      for (int at = 0; at < row.length; at += channels) {
        raster.put(row[at + red] >> shift, row[at + 1] >> shift, row[at + 2 - red] >> shift);
      }
    }
    return raster.data();
  }

  /** Other numbers, three or four a pixel: from the smallest to the largest of all channels. */
  static ImageData ranged(RawImage raw, Levels levels) {
    Samples samples = new Samples(raw);
    float[] row = new float[samples.perRow()];
    Span span = span(raw, samples, row, levels);
    int channels = raw.encoding().channels();
    float low = (float) span.low();
    float factor = (float) (BRIGHTEST / (span.high() - span.low()));
    Raster raster = new Raster(raw.width(), raw.height());
    for (int y = 0; y < raw.height(); y++) {
      samples.real(y, row);
      for (int at = 0; at < row.length; at += channels) {
        raster.put(level((row[at + 2] - low) * factor), level((row[at + 1] - low) * factor),
            level((row[at] - low) * factor));
      }
    }
    return raster.data();
  }

  private static Span span(RawImage raw, Samples samples, float[] row, Levels levels) {
    float[] some = new float[SAMPLED];
    long step = Math.max(1, (long) row.length * raw.height() / SAMPLED + 1);
    int count = 0;
    int read = -1;
    for (long i = 0; i < (long) row.length * raw.height(); i += step) {
      int y = (int) (i / row.length);
      if (y != read) {
        samples.real(y, row);
        read = y;
      }
      float number = row[(int) (i % row.length)];
      if (Float.isFinite(number)) {
        some[count++] = number;
      }
    }
    return levels.follow(some, count);
  }

  /** What is not a number is dark. */
  private static int level(float scaled) {
    int level = (int) (scaled + 0.5f);
    return level < 0 ? 0 : Math.min(level, BRIGHTEST);
  }

  private static boolean redFirst(PixelEncoding encoding) {
    return encoding.name().startsWith("RGB");
  }
}
