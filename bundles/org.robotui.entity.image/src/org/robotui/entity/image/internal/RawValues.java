package org.robotui.entity.image.internal;

import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.entity.image.Picture;
import org.robotui.ui.Figures;

/**
 * The values of raw pixels as the robot sent them.
 *
 * @param raw the picture
 * @param quantity what its numbers stand for
 */
record RawValues(RawImage raw, Quantity quantity) implements Picture.PixelText {
  private static final int DEPTH_DECIMALS = 3;
  private static final String BAYER = "BAYER_";

  @Override
  public String at(int x, int y) {
    // The samples are made anew: a read-out is asked for on another thread than the one that decoded.
    Samples samples = new Samples(raw);
    PixelEncoding encoding = raw.encoding();
    if (quantity.depth()) {
      return depth(samples.at(x, y, 0), encoding.sample());
    }
    String name = encoding.name();
    if (name.startsWith(BAYER)) {
      return name.charAt(BAYER.length() + 2 * (y & 1) + (x & 1)) + " " + number(samples.at(x, y, 0), encoding.sample());
    }
    return switch (encoding) {
      case UYVY -> luminance(samples, x, y, 1);
      case YUYV -> luminance(samples, x, y, 0);
      default -> IntStream.range(0, encoding.channels())
          .mapToObj(c -> number(samples.at(x, y, c), encoding.sample()))
          .collect(Collectors.joining(" "));
    };
  }

  private String depth(double number, PixelEncoding.Sample form) {
    boolean whole = form == PixelEncoding.Sample.U16;
    String sent = number(number, form);
    if (!quantity.measured(number)) {
      return sent + " = no depth";
    }
    String metres = Figures.of(number * quantity.scale(), DEPTH_DECIMALS, quantity.unit());
    return whole ? sent + " = " + metres : metres;
  }

  private static String luminance(Samples samples, int x, int y, int at) {
    return "Y " + (int) samples.at(x, y, at) + ((x & 1) == 0 ? " U " : " V ") + (int) samples.at(x, y, 1 - at);
  }

  private static String number(double value, PixelEncoding.Sample form) {
    return switch (form) {
      case F32, F64 -> Double.isFinite(value)
          ? String.format(Locale.ROOT, "%.5g", value).replace('-', '\u2212')
          : Double.isNaN(value) ? "NaN" : Figures.fixed(value, 0);
      default -> Figures.fixed(value, 0);
    };
  }
}
