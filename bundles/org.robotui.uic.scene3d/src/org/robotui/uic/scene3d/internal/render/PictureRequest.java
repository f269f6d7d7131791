package org.robotui.uic.scene3d.internal.render;

import org.robotui.gl.shape.Rgba;

/**
 * What a picture is made for.
 *
 * @param width pixels, 0 where nothing is seen
 * @param height pixels
 * @param scale pixels a point
 * @param background behind everything
 */
public record PictureRequest(int width, int height, float scale, Rgba background) {
  /** Nobody looks yet. */
  public static final PictureRequest NONE = new PictureRequest(0, 0, 1, Rgba.of(0));
}
