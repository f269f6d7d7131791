package org.robotui.entity.image.internal;

import java.util.stream.IntStream;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.PaletteData;
import org.eclipse.swt.graphics.RGB;
import org.robotui.data.RawImage;

/** Pictures of one channel, as grey. */
final class Greys {
  private static final int DEPTH = 8;
  private static final int DARKEST = 24;
  private static final int LIGHTEST = 255;

  private Greys() {}

  static PaletteData palette() {
    return new PaletteData(IntStream.rangeClosed(0, LIGHTEST).mapToObj(level -> new RGB(level, level, level)).toArray(RGB[]::new));
  }

  static ImageData plain(RawImage raw) {
    byte[] target = new byte[raw.width() * raw.height()];
    for (int y = 0; y < raw.height(); y++) {
      raw.pixels().copyTo(y * raw.step(), target, y * raw.width(), raw.width());
    }
    return new ImageData(raw.width(), raw.height(), DEPTH, palette(), 1, target);
  }

  /** The smallest measured value dark, the largest light, what was not measured black. */
  static ImageData ranged(RawImage raw) {
    float[] values = values(raw);
    double min = Double.POSITIVE_INFINITY;
    double max = Double.NEGATIVE_INFINITY;
    for (float value : values) {
      if (Float.isFinite(value)) {
        min = Math.min(min, value);
        max = Math.max(max, value);
      }
    }
    double factor = max > min ? (LIGHTEST - DARKEST) / (max - min) : 0;
    byte[] target = new byte[values.length];
    for (int i = 0; i < values.length; i++) {
      target[i] = Float.isFinite(values[i]) ? (byte) Math.round(DARKEST + (values[i] - min) * factor) : 0;
    }
    return new ImageData(raw.width(), raw.height(), DEPTH, palette(), 1, target);
  }

  private static float[] values(RawImage raw) {
    Samples samples = new Samples(raw);
    float[] values = new float[raw.width() * raw.height()];
    for (int y = 0, i = 0; y < raw.height(); y++) {
      for (int x = 0; x < raw.width(); x++, i++) {
        values[i] = samples.at(x, y);
      }
    }
    return values;
  }
}
