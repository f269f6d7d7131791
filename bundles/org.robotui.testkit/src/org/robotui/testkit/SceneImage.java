package org.robotui.testkit;

/**
 * A picture of a scene.
 *
 * @param width pixels
 * @param height rows
 * @param rgb row by row from the top, red in bits 16 to 23, green in 8 to 15, blue in 0 to 7
 */
public record SceneImage(int width, int height, int[] rgb) {
  private static final int CHANNEL = 0xff;

  /**
   * A pixel.
   *
   * @param x from the left
   * @param y from the top
   * @return its colour
   */
  public int at(int x, int y) {
    return rgb[y * width + x];
  }

  /**
   * Counts the pixels that are not as in another picture.
   *
   * @param other of the same size
   * @param tolerance by how much red, green or blue may differ, of 255
   * @return how many differ by more; all where the size is another
   */
  public int differences(SceneImage other, int tolerance) {
    if (width != other.width || height != other.height) {
      return rgb.length;
    }
    int count = 0;
    for (int i = 0; i < rgb.length; i++) {
      count += distance(rgb[i], other.rgb[i]) > tolerance ? 1 : 0;
    }
    return count;
  }

  /**
   * Counts the pixels that are nearly of a colour.
   *
   * @param color the colour
   * @param tolerance by how much red, green or blue may differ, of 255
   * @return how many
   */
  public int count(int color, int tolerance) {
    int count = 0;
    for (int pixel : rgb) {
      count += distance(pixel, color) <= tolerance ? 1 : 0;
    }
    return count;
  }

  private static int distance(int a, int b) {
    int red = Math.abs((a >> 16 & CHANNEL) - (b >> 16 & CHANNEL));
    int green = Math.abs((a >> 8 & CHANNEL) - (b >> 8 & CHANNEL));
    int blue = Math.abs((a & CHANNEL) - (b & CHANNEL));
    return Math.max(red, Math.max(green, blue));
  }
}
