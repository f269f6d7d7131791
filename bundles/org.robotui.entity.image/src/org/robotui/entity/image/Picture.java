package org.robotui.entity.image;

import org.eclipse.swt.graphics.ImageData;

/**
 * A decoded picture.
 *
 * @param pixels what to paint; not to be changed
 * @param encoding as users read it, for example {@code rgb8} or {@code jpeg}
 * @param values what the robot sent for a pixel
 */
public record Picture(ImageData pixels, String encoding, PixelText values) {
  /** Says what a pixel holds. */
  @FunctionalInterface
  public interface PixelText {
    /**
     * The value of a pixel as the robot sent it. Any thread.
     *
     * @param x column, 0 to width - 1
     * @param y row, 0 to height - 1
     * @return for example {@code 12 34 56}, or {@code 1.234 m} of a depth picture
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
}
