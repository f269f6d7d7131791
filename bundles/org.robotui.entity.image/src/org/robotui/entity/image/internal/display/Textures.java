package org.robotui.entity.image.internal.display;

import java.nio.ByteBuffer;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.PaletteData;
import org.eclipse.swt.graphics.RGB;
import org.robotui.entity.image.Picture;
import org.robotui.gl.shape.Texture;

/** Pictures as textures, no larger than wanted. Pure; takes milliseconds. */
final class Textures {
  private static final int OPAQUE = 0xff;

  private Textures() {}

  static Texture of(Picture picture, int most) {
    int factor = Math.ceilDiv(Math.max(picture.width(), picture.height()), Math.min(most, Texture.MOST));
    ImageData pixels = picture.shrunk(factor);
    ByteBuffer rgba = ByteBuffer.allocateDirect(Math.multiplyExact(4, Math.multiplyExact(pixels.width, pixels.height)));
    int[] row = new int[pixels.width];
    int[] colors = pixels.palette.isDirect ? new int[0] : indexed(pixels.palette);
    for (int y = 0; y < pixels.height; y++) {
      pixels.getPixels(0, y, pixels.width, row, 0);
      for (int pixel : row) {
        rgba.putInt(pixels.palette.isDirect ? direct(pixels.palette, pixel)
            : pixel >= 0 && pixel < colors.length ? colors[pixel] : OPAQUE);
      }
    }
    return new Texture(pixels.width, pixels.height, rgba.flip(), true);
  }

  private static int[] indexed(PaletteData palette) {
    RGB[] colors = palette.getRGBs();
    int[] packed = new int[colors.length];
    for (int i = 0; i < colors.length; i++) {
      packed[i] = packed(colors[i].red, colors[i].green, colors[i].blue);
    }
    return packed;
  }

  private static int direct(PaletteData palette, int pixel) {
    return packed(part(pixel & palette.redMask, palette.redShift), part(pixel & palette.greenMask, palette.greenShift),
        part(pixel & palette.blueMask, palette.blueShift));
  }

  /** As SWT's palettes count: negative shifts go to the right. */
  private static int part(int masked, int shift) {
    return (shift < 0 ? masked >>> -shift : masked << shift) & OPAQUE;
  }

  private static int packed(int red, int green, int blue) {
    return red << 24 | green << 16 | blue << 8 | OPAQUE;
  }
}
