package org.robotui.data.image;

import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.internal.Check;

/**
 * A picture as pixels, rows from top to bottom.
 *
 * @param frame optical frame of the camera
 * @param width pixels a row
 * @param height rows
 * @param encoding how a pixel is stored
 * @param bigEndian byte order of pixels wider than a byte
 * @param step bytes a row
 * @param pixels the bytes, at least {@code height * step}
 */
public record RawImage(
    FrameId frame, int width, int height, PixelEncoding encoding, boolean bigEndian, int step, Bytes pixels)
    implements Image {
  /**
   * Checks that the rows fit into the bytes.
   *
   * @param frame optical frame
   * @param width pixels a row
   * @param height rows
   * @param encoding how a pixel is stored
   * @param bigEndian byte order
   * @param step bytes a row
   * @param pixels the bytes
   */
  public RawImage {
    Check.notNegative(width, "width");
    Check.notNegative(height, "height");
    Check.that((long) width * encoding.bytesPerPixel() <= step, "step", "too short for " + width + " pixels");
    Check.that((long) height * step <= pixels.size(), "pixels", "too short for " + height + " rows of " + step);
  }
}
