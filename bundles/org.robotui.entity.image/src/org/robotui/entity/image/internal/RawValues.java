package org.robotui.entity.image.internal;

import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.robotui.data.PixelEncoding;
import org.robotui.data.RawImage;
import org.robotui.entity.image.Picture;
import org.robotui.ui.Figures;

/**
 * The values of raw pixels as the robot sent them.
 *
 * @param raw the picture
 */
record RawValues(RawImage raw) implements Picture.PixelText {
  private static final int DEPTH_DECIMALS = 3;

  @Override
  public String at(int x, int y) {
    return switch (raw.encoding()) {
      case F32C1 -> Figures.of(new Samples(raw).at(x, y), DEPTH_DECIMALS, "m");
      case U16C1, MONO16 -> Figures.fixed(new Samples(raw).at(x, y), 0);
      default -> bytes(y * raw.step() + x * raw.encoding().bytesPerPixel(), raw.encoding());
    };
  }

  private String bytes(int at, PixelEncoding encoding) {
    return IntStream.range(0, encoding.bytesPerPixel())
        .mapToObj(i -> Integer.toString(raw.pixels().unsigned(at + i)))
        .collect(Collectors.joining(" "));
  }
}
