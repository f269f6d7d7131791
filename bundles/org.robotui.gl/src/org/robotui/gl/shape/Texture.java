package org.robotui.gl.shape;

import java.nio.ByteBuffer;

/**
 * A picture for surfaces.
 *
 * @param width pixels a row
 * @param height rows
 * @param rgba four bytes red, green, blue, alpha a pixel, row by row from the top
 * @param smooth true where pixels blend when seen close, false where each keeps its edges, as cells of maps do
 * @param repeats true where it begins anew outside of 0 to 1, as pictures on meshes do, false where its edge goes on
 */
public record Texture(int width, int height, ByteBuffer rgba, boolean smooth, boolean repeats) {
  /** The most pixels along an edge that every renderer takes. */
  public static final int MOST = 8192;

  /**
   * Checks the size.
   *
   * @param width pixels
   * @param height rows
   * @param rgba the pixels
   * @param smooth blends
   * @param repeats begins anew
   */
  public Texture {
    if (width < 1 || height < 1 || width > MOST || height > MOST) {
      throw new IllegalArgumentException("a texture of " + width + " x " + height + ", must be 1 to " + MOST + " each");
    }
    rgba = rgba.slice();
    Colors.fit(rgba, width * height);
  }

  /**
   * A picture whose edge goes on.
   *
   * @param width pixels
   * @param height rows
   * @param rgba the pixels
   * @param smooth blends
   */
  public Texture(int width, int height, ByteBuffer rgba, boolean smooth) {
    this(width, height, rgba, smooth, false);
  }
}
