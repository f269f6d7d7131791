package org.robotui.data;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** How a pixel is stored. The names in lower case are those of ROS. */
public enum PixelEncoding {
  /** Red, green, blue. */
  RGB8(3),
  /** Blue, green, red. */
  BGR8(3),
  /** Red, green, blue, opacity. */
  RGBA8(4),
  /** Blue, green, red, opacity. */
  BGRA8(4),
  /** Brightness. */
  MONO8(1),
  /** Brightness, 16 bits. */
  MONO16(2),
  /** Depth in millimetres or any other 16 bit quantity. */
  U16C1(2),
  /** Depth in metres, 32 bit floating point. */
  F32C1(4),
  /** Raw sensor, red first row first column. */
  BAYER_RGGB8(1),
  /** Raw sensor, blue first. */
  BAYER_BGGR8(1),
  /** Raw sensor, green then blue. */
  BAYER_GBRG8(1),
  /** Raw sensor, green then red. */
  BAYER_GRBG8(1),
  /** Luminance and alternating chroma, u first. */
  UYVY(2),
  /** Luminance and alternating chroma, y first. */
  YUYV(2);

  private final int bytesPerPixel;

  PixelEncoding(int bytesPerPixel) {
    this.bytesPerPixel = bytesPerPixel;
  }

  /**
   * Finds an encoding by the name that ROS uses.
   *
   * @param name for example {@code rgb8}, {@code 16UC1}, {@code 32FC1}, {@code 8UC1}, {@code yuv422}
   * @return the encoding, or none where it is not known
   */
  public static Optional<PixelEncoding> fromRos(String name) {
    return switch (name) {
      case "16UC1" -> Optional.of(U16C1);
      case "32FC1" -> Optional.of(F32C1);
      case "8UC1" -> Optional.of(MONO8);
      case "8UC3" -> Optional.of(BGR8);
      case "8UC4" -> Optional.of(BGRA8);
      case "yuv422" -> Optional.of(UYVY);
      case "yuv422_yuy2" -> Optional.of(YUYV);
      default -> Arrays.stream(values()).filter(e -> e.name().toLowerCase(Locale.ROOT).equals(name)).findFirst();
    };
  }

  /**
   * The size of a pixel.
   *
   * @return bytes
   */
  public int bytesPerPixel() {
    return bytesPerPixel;
  }
}
