package org.robotui.entity.image.internal;

import java.util.Optional;
import org.eclipse.swt.graphics.ImageData;
import org.robotui.data.image.RawImage;
import org.robotui.entity.image.Picture;
import org.robotui.entity.image.Rendering;

/** Turns raw pixels into what a window paints. */
public final class RawPictures {
  private RawPictures() {}

  /**
   * Decodes.
   *
   * @param raw a picture with at least one pixel
   * @param rendering how numbers become colours
   * @param levels what is held from picture to picture
   * @return the picture
   */
  public static Picture decode(RawImage raw, Rendering rendering, Levels levels) {
    levels.begin(raw.encoding());
    return switch (raw.encoding()) {
      case RGB8, BGR8, U8C3, MONO8, U8C1 -> picture(raw, Colors.packed(raw));
      case RGBA8, BGRA8, U8C4, RGB16, BGR16, RGBA16, BGRA16, U16C3, U16C4 -> picture(raw, Colors.whole(raw, levels));
      case BAYER_RGGB8, BAYER_BGGR8, BAYER_GBRG8, BAYER_GRBG8, BAYER_RGGB16, BAYER_BGGR16, BAYER_GBRG16,
          BAYER_GRBG16 -> picture(raw, Bayer.decode(raw, levels));
      case UYVY, YUYV -> picture(raw, Yuv.decode(raw));
      default -> raw.encoding().channels() > 2
          ? picture(raw, Colors.ranged(raw, levels))
          : Measured.decode(raw, rendering, levels);
    };
  }

  private static Picture picture(RawImage raw, ImageData pixels) {
    return new Picture(pixels, raw.encoding().rosName(), new RawValues(raw, Quantity.of(raw.encoding(), false)),
        Optional.empty(), Optional.empty());
  }
}
