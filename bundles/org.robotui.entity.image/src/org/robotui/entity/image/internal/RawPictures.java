package org.robotui.entity.image.internal;

import java.util.Locale;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.PaletteData;
import org.robotui.data.RawImage;
import org.robotui.entity.image.Decoding;
import org.robotui.entity.image.Picture;

/** Turns raw pixels into what a window paints. */
public final class RawPictures {
  static final PaletteData RGB = new PaletteData(0xff0000, 0xff00, 0xff);
  static final PaletteData BGR = new PaletteData(0xff, 0xff00, 0xff0000);

  private static final int COLOR_DEPTH = 24;
  private static final int COLOR_BYTES = 3;

  private RawPictures() {}

  /**
   * Decodes.
   *
   * @param raw a picture with at least one pixel
   * @return the picture
   */
  public static Decoding decode(RawImage raw) {
    return new Decoding.Decoded(new Picture(pixels(raw), name(raw), new RawValues(raw)));
  }

  static ImageData pixels(RawImage raw) {
    return switch (raw.encoding()) {
      case RGB8 -> packed(raw, RGB);
      case BGR8 -> packed(raw, BGR);
      case RGBA8 -> color(raw, (x, y, at) -> rgb(raw, at, 0, 1, 2));
      case BGRA8 -> color(raw, (x, y, at) -> rgb(raw, at, 2, 1, 0));
      case MONO8 -> Greys.plain(raw);
      case MONO16, U16C1, F32C1 -> Greys.ranged(raw);
      case BAYER_RGGB8 -> color(raw, new Bayer(raw, 0, 0));
      case BAYER_GRBG8 -> color(raw, new Bayer(raw, 1, 0));
      case BAYER_GBRG8 -> color(raw, new Bayer(raw, 0, 1));
      case BAYER_BGGR8 -> color(raw, new Bayer(raw, 1, 1));
      case UYVY -> color(raw, new Yuv(raw, 1, 0));
      case YUYV -> color(raw, new Yuv(raw, 0, 1));
    };
  }

  private static String name(RawImage raw) {
    return switch (raw.encoding()) {
      case U16C1 -> "16UC1";
      case F32C1 -> "32FC1";
      default -> raw.encoding().name().toLowerCase(Locale.ROOT);
    };
  }

  /** The bytes lie as the window wants them: whole rows are copied. */
  private static ImageData packed(RawImage raw, PaletteData palette) {
    int row = raw.width() * COLOR_BYTES;
    byte[] target = new byte[row * raw.height()];
    for (int y = 0; y < raw.height(); y++) {
      raw.pixels().copyTo(y * raw.step(), target, y * row, row);
    }
    return new ImageData(raw.width(), raw.height(), COLOR_DEPTH, palette, 1, target);
  }

  private static ImageData color(RawImage raw, Converter converter) {
    byte[] target = new byte[raw.width() * raw.height() * COLOR_BYTES];
    int out = 0;
    for (int y = 0; y < raw.height(); y++) {
      int at = y * raw.step();
      for (int x = 0; x < raw.width(); x++) {
        int pixel = converter.rgb(x, y, at);
        target[out++] = (byte) (pixel >> 16);
        target[out++] = (byte) (pixel >> 8);
        target[out++] = (byte) pixel;
        at += raw.encoding().bytesPerPixel();
      }
    }
    return new ImageData(raw.width(), raw.height(), COLOR_DEPTH, RGB, 1, target);
  }

  private static int rgb(RawImage raw, int at, int red, int green, int blue) {
    return raw.pixels().unsigned(at + red) << 16 | raw.pixels().unsigned(at + green) << 8 | raw.pixels().unsigned(at + blue);
  }

  /** The colour of a pixel. */
  interface Converter {
    int rgb(int x, int y, int at);
  }
}
