package org.robotui.entity.image;

import java.util.Optional;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.robotui.data.image.RawImage;
import org.robotui.entity.image.internal.Shrinking;

/**
 * A decoded picture.
 *
 * @param pixels what to paint; not to be changed
 * @param encoding as users read it, for example {@code rgb8} or {@code jpeg}
 * @param values what the robot sent for a pixel
 * @param legend what the colours mean, where they stand for numbers
 * @param numbers the numbers behind the colours, of pictures with one number of 16 or more bits a pixel
 */
public record Picture(
    ImageData pixels, String encoding, PixelText values, Optional<Legend> legend, Optional<RawImage> numbers) {
  /** Says what a pixel holds. */
  @FunctionalInterface
  public interface PixelText {
    /**
     * The value of a pixel as the robot sent it. Any thread.
     *
     * @param x column, 0 to width - 1
     * @param y row, 0 to height - 1
     * @return for example {@code 12 34 56}, or {@code 1234 = 1.234 m} of a depth picture
     */
    String at(int x, int y);
  }

  /**
   * Pixels a row.
   *
   * @return at least 1
   */
  public int width() {
    return pixels.width;
  }

  /**
   * Rows.
   *
   * @return at least 1
   */
  public int height() {
    return pixels.height;
  }

  /**
   * The colour with which a pixel is painted.
   *
   * @param x column
   * @param y row
   * @return its colour
   */
  public RGB color(int x, int y) {
    return pixels.palette.getRGB(pixels.getPixel(x, y));
  }

  /**
   * The picture as it looks from afar: blocks of pixels become one, of their mean colour. Takes a few milliseconds.
   *
   * @param factor edge of the blocks, pixels; 1 for the picture itself
   * @return what to paint
   */
  public ImageData shrunk(int factor) {
    return factor <= 1 ? pixels : Shrinking.of(pixels, factor);
  }
}
