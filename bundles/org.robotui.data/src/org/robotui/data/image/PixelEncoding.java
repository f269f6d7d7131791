package org.robotui.data.image;

import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * How a pixel is stored. The names are those of ROS; the meaning of the abstract ones, say 32FC3, is left to who sends
 * them.
 */
public enum PixelEncoding {
  /** Red, green, blue. */
  RGB8(Sample.U8, 3),
  /** Blue, green, red. */
  BGR8(Sample.U8, 3),
  /** Red, green, blue, opacity. */
  RGBA8(Sample.U8, 4),
  /** Blue, green, red, opacity. */
  BGRA8(Sample.U8, 4),
  /** Red, green, blue, 16 bits each. */
  RGB16(Sample.U16, 3),
  /** Blue, green, red, 16 bits each. */
  BGR16(Sample.U16, 3),
  /** Red, green, blue, opacity, 16 bits each. */
  RGBA16(Sample.U16, 4),
  /** Blue, green, red, opacity, 16 bits each. */
  BGRA16(Sample.U16, 4),
  /** Brightness. */
  MONO8(Sample.U8, 1),
  /** Brightness, 16 bits. */
  MONO16(Sample.U16, 1),
  /** Raw sensor, red first row first column. */
  BAYER_RGGB8(Sample.U8, 1),
  /** Raw sensor, blue first. */
  BAYER_BGGR8(Sample.U8, 1),
  /** Raw sensor, green then blue. */
  BAYER_GBRG8(Sample.U8, 1),
  /** Raw sensor, green then red. */
  BAYER_GRBG8(Sample.U8, 1),
  /** Raw sensor, red first row first column, 16 bits. */
  BAYER_RGGB16(Sample.U16, 1),
  /** Raw sensor, blue first, 16 bits. */
  BAYER_BGGR16(Sample.U16, 1),
  /** Raw sensor, green then blue, 16 bits. */
  BAYER_GBRG16(Sample.U16, 1),
  /** Raw sensor, green then red, 16 bits. */
  BAYER_GRBG16(Sample.U16, 1),
  /** Luminance and alternating chroma, u first. */
  UYVY(Sample.U8, 2),
  /** Luminance and alternating chroma, y first. */
  YUYV(Sample.U8, 2),
  /** One unsigned byte. */
  U8C1(Sample.U8, 1),
  /** Two unsigned bytes. */
  U8C2(Sample.U8, 2),
  /** Three unsigned bytes; by convention blue, green, red. */
  U8C3(Sample.U8, 3),
  /** Four unsigned bytes; by convention blue, green, red, opacity. */
  U8C4(Sample.U8, 4),
  /** One signed byte. */
  S8C1(Sample.S8, 1),
  /** Two signed bytes. */
  S8C2(Sample.S8, 2),
  /** Three signed bytes. */
  S8C3(Sample.S8, 3),
  /** Four signed bytes. */
  S8C4(Sample.S8, 4),
  /** Depth in millimetres or any other 16 bit quantity. */
  U16C1(Sample.U16, 1),
  /** Two unsigned numbers of 16 bits. */
  U16C2(Sample.U16, 2),
  /** Three unsigned numbers of 16 bits; by convention blue, green, red. */
  U16C3(Sample.U16, 3),
  /** Four unsigned numbers of 16 bits; by convention blue, green, red, opacity. */
  U16C4(Sample.U16, 4),
  /** A signed number of 16 bits. */
  S16C1(Sample.S16, 1),
  /** Two signed numbers of 16 bits. */
  S16C2(Sample.S16, 2),
  /** Three signed numbers of 16 bits. */
  S16C3(Sample.S16, 3),
  /** Four signed numbers of 16 bits. */
  S16C4(Sample.S16, 4),
  /** A signed number of 32 bits. */
  S32C1(Sample.S32, 1),
  /** Two signed numbers of 32 bits. */
  S32C2(Sample.S32, 2),
  /** Three signed numbers of 32 bits. */
  S32C3(Sample.S32, 3),
  /** Four signed numbers of 32 bits. */
  S32C4(Sample.S32, 4),
  /** Depth in metres or any other quantity, 32 bit floating point. */
  F32C1(Sample.F32, 1),
  /** Two 32 bit floating point numbers. */
  F32C2(Sample.F32, 2),
  /** Three 32 bit floating point numbers. */
  F32C3(Sample.F32, 3),
  /** Four 32 bit floating point numbers. */
  F32C4(Sample.F32, 4),
  /** A 64 bit floating point number. */
  F64C1(Sample.F64, 1),
  /** Two 64 bit floating point numbers. */
  F64C2(Sample.F64, 2),
  /** Three 64 bit floating point numbers. */
  F64C3(Sample.F64, 3),
  /** Four 64 bit floating point numbers. */
  F64C4(Sample.F64, 4);

  private static final Map<String, PixelEncoding> BY_NAME =
      Arrays.stream(values()).collect(Collectors.toUnmodifiableMap(PixelEncoding::rosName, Function.identity()));

  private final Sample sample;
  private final int channels;

  PixelEncoding(Sample sample, int channels) {
    this.sample = sample;
    this.channels = channels;
  }

  /** How a number is stored. */
  public enum Sample {
    /** Unsigned byte. */
    U8(1),
    /** Signed byte. */
    S8(1),
    /** Unsigned, 16 bits. */
    U16(2),
    /** Signed, 16 bits. */
    S16(2),
    /** Signed, 32 bits. */
    S32(4),
    /** Floating point, 32 bits. */
    F32(4),
    /** Floating point, 64 bits. */
    F64(8);

    private final int bytes;

    Sample(int bytes) {
      this.bytes = bytes;
    }

    /**
     * The size of a number.
     *
     * @return bytes
     */
    public int bytes() {
      return bytes;
    }
  }

  /**
   * Finds an encoding by the name that ROS uses.
   *
   * @param name for example {@code rgb8}, {@code 16UC1}, {@code 32FC1}, {@code yuv422}
   * @return the encoding, or none where it is not known
   */
  public static Optional<PixelEncoding> fromRos(String name) {
    return switch (name) {
      case "uyvy" -> Optional.of(UYVY);
      case "yuyv" -> Optional.of(YUYV);
      default -> Optional.ofNullable(BY_NAME.get(name));
    };
  }

  /**
   * The name that ROS uses.
   *
   * @return for example {@code rgb8}, {@code 16UC1}, {@code yuv422}
   */
  public String rosName() {
    return switch (this) {
      case UYVY -> "yuv422";
      case YUYV -> "yuv422_yuy2";
      default -> isAbstract() ? abstractName() : name().toLowerCase(Locale.ROOT);
    };
  }

  /**
   * How each number of a pixel is stored.
   *
   * @return the form
   */
  public Sample sample() {
    return sample;
  }

  /**
   * How many numbers a pixel has.
   *
   * @return 1 to 4
   */
  public int channels() {
    return channels;
  }

  /**
   * The size of a pixel.
   *
   * @return bytes
   */
  public int bytesPerPixel() {
    return channels * sample.bytes();
  }

  private boolean isAbstract() {
    return name().equals(sample.name() + "C" + channels);
  }

  private String abstractName() {
    return sample.name().substring(1) + sample.name().charAt(0) + "C" + channels;
  }
}
