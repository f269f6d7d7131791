package org.robotui.urdf.mesh;

import java.nio.ByteBuffer;

/**
 * A picture for a surface.
 *
 * @param width pixels a row, 1 to {@link #MOST}
 * @param height rows, 1 to {@link #MOST}
 * @param rgba four bytes red, green, blue, alpha a pixel, row by row from the top; can only be read
 */
public record Picture(int width, int height, ByteBuffer rgba) {
  /** The most pixels along an edge; what a file has more is left out evenly. */
  public static final int MOST = 4096;

  /**
   * Makes the buffer read-only.
   *
   * @param width pixels
   * @param height rows
   * @param rgba the pixels
   */
  public Picture {
    rgba = rgba.asReadOnlyBuffer();
  }
}
