package org.robotui.entity.image.internal;

import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;

/** The numbers of a picture in 16 bits. */
public final class Depth16 {
  private static final double MILLIS = 1000;
  private static final int LARGEST = 0xffff;

  private Depth16() {}

  /**
   * Whether its numbers can be kept in 16 bits.
   *
   * @param raw the picture
   * @return true for unsigned 16 bits and depth in metres
   */
  public static boolean fits(RawImage raw) {
    return raw.encoding().channels() == 1 && switch (raw.encoding().sample()) {
      case U16, F32, F64 -> true;
      default -> false;
    };
  }

  /**
   * Copies them: whole numbers as they are, metres as millimetres.
   *
   * @param raw a picture that fits
   * @param target a number a pixel
   */
  public static void copy(RawImage raw, short[] target) {
    Samples samples = new Samples(raw);
    boolean whole = raw.encoding().sample() == PixelEncoding.Sample.U16;
    for (int i = 0; i < target.length; i++) {
      double number = samples.at(i % raw.width(), i / raw.width(), 0);
      target[i] = (short) (whole ? (int) number : millis(number));
    }
  }

  private static int millis(double metres) {
    double millis = metres * MILLIS;
    return millis > 0 && millis <= LARGEST ? (int) Math.round(millis) : 0;
  }
}
