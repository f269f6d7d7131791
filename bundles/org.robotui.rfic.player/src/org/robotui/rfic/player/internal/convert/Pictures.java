package org.robotui.rfic.player.internal.convert;

import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.Image;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.player.interfaces.Camera;

/** Pictures of cameras. */
public final class Pictures {
  private static final int JPEG = 1;
  private static final int GREY = 1;
  private static final int GREY16 = 2;
  private static final int RGB565 = 4;
  private static final int RGB888 = 5;
  private static final int MOST_PIXELS = 1 << 24;

  private Pictures() {}

  public static Image of(Camera.Image m, FrameId frame) {
    if (m.compression() == JPEG) {
      return new CompressedImage(frame, "jpeg", Bytes.wrap(m.data(), 0, m.data().length));
    }
    if (m.compression() != 0) {
      throw new IllegalArgumentException(
          "compression: " + m.compression() + " is none that Player has (0 none, 1 JPEG)");
    }
    if (m.width() * m.height() > MOST_PIXELS || m.width() > MOST_PIXELS) {
      throw new IllegalArgumentException(
          "a picture of " + m.width() + " x " + m.height() + " pixels is more than a message can hold");
    }
    int width = (int) m.width();
    int height = (int) m.height();
    return switch ((int) m.format()) {
      case GREY -> raw(frame, width, height, PixelEncoding.MONO8, m.data());
      case GREY16 -> raw(frame, width, height, PixelEncoding.MONO16, m.data());
      case RGB565 -> raw(frame, width, height, PixelEncoding.RGB8, widened(m.data(), width * height));
      case RGB888 -> raw(frame, width, height, PixelEncoding.RGB8, m.data());
      default -> throw new IllegalArgumentException(
          "format: " + m.format() + " is none that Player has (1 grey, 2 grey of 16 bits, 4 RGB565, 5 RGB888)");
    };
  }

  /** Grey of 16 bits is sent in the network's order. */
  private static RawImage raw(FrameId frame, int width, int height, PixelEncoding encoding, byte[] data) {
    return new RawImage(frame, width, height, encoding, true, width * encoding.bytesPerPixel(),
        Bytes.wrap(data, 0, data.length));
  }

  /** Pixels of 5, 6 and 5 bits lie as a frame grabber leaves them, lower byte first. */
  private static byte[] widened(byte[] data, int pixels) {
    if (data.length < 2 * pixels) {
      throw new IllegalArgumentException("data: " + data.length + " bytes are too few for " + pixels + " pixels");
    }
    byte[] rgb = new byte[3 * pixels];
    for (int i = 0; i < pixels; i++) {
      int pixel = data[2 * i] & 0xff | (data[2 * i + 1] & 0xff) << 8;
      rgb[3 * i] = (byte) ((pixel >> 11) * 255 / 31);
      rgb[3 * i + 1] = (byte) ((pixel >> 5 & 0x3f) * 255 / 63);
      rgb[3 * i + 2] = (byte) ((pixel & 0x1f) * 255 / 31);
    }
    return rgb;
  }
}
