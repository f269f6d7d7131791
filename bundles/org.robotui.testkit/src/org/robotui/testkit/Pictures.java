package org.robotui.testkit;

import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;

/** Makes pictures for tests. */
public final class Pictures {
  private static final FrameId FRAME = new FrameId("Keira", "camera");
  private static final int RGB = 3;

  private Pictures() {}

  /**
   * A picture of given bytes without padding.
   *
   * @param encoding how a pixel is stored
   * @param width pixels a row
   * @param height rows
   * @param bytes the pixels, little endian
   * @return the picture
   */
  public static RawImage raw(PixelEncoding encoding, int width, int height, byte... bytes) {
    return new RawImage(FRAME, width, height, encoding, false, width * encoding.bytesPerPixel(), Bytes.of(bytes));
  }

  /**
   * A room with a horizon, a grey and a red box.
   *
   * @param width pixels a row
   * @param height rows
   * @return an rgb8 picture
   */
  public static RawImage room(int width, int height) {
    byte[] bytes = new byte[width * height * RGB];
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int pixel = roomPixel((double) x / width, (double) y / height);
        int at = (y * width + x) * RGB;
        bytes[at] = (byte) (pixel >> 16);
        bytes[at + 1] = (byte) (pixel >> 8);
        bytes[at + 2] = (byte) pixel;
      }
    }
    return raw(PixelEncoding.RGB8, width, height, bytes);
  }

  private static int roomPixel(double x, double y) {
    if (within(x, 0.32, 0.63) && within(y, 0.25, 0.61)) {
      return 0x3c444d;
    }
    if (within(x, 0.71, 0.87) && within(y, 0.29, 0.56)) {
      return 0xa86048;
    }
    return y < 0.55 ? grey(92 + y * 90, 8) : grey(125 - y * 60, -14);
  }

  private static int grey(double level, int tint) {
    int base = (int) level;
    return base - tint << 16 | base << 8 | base + tint;
  }

  private static boolean within(double value, double from, double to) {
    return value >= from && value < to;
  }
}
