package org.robotui.gl.shape;

import java.util.Optional;

/**
 * How a shape's surface looks.
 *
 * @param color multiplies the colours of points and texture; an alpha below 1 makes it transparent
 * @param lit true where light falls on it, false where colours are shown as they are
 * @param texture a picture on a mesh with places in it
 * @param depth what hides it
 * @param pale how much of the background is mixed in, 0 to 1; unlike a transparent surface a pale one hides what is
 * behind it
 */
public record Material(Rgba color, boolean lit, Optional<Texture> texture, Depth depth, float pale) {
  /** What hides a shape. */
  public enum Depth {
    /** What lies before it. */
    TESTED,
    /** Nothing: handles and marks that must be seen. */
    ON_TOP
  }

  /**
   * Not pale.
   *
   * @param color multiplies the colours of points and texture
   * @param lit whether light falls on it
   * @param texture a picture on a mesh
   * @param depth what hides it
   */
  public Material(Rgba color, boolean lit, Optional<Texture> texture, Depth depth) {
    this(color, lit, texture, depth, 0);
  }

  /**
   * A surface in light.
   *
   * @param color its colour
   * @return the material
   */
  public static Material lit(Rgba color) {
    return new Material(color, true, Optional.empty(), Depth.TESTED);
  }

  /**
   * A colour as it is.
   *
   * @param color the colour
   * @return the material
   */
  public static Material flat(Rgba color) {
    return new Material(color, false, Optional.empty(), Depth.TESTED);
  }

  /**
   * A picture as it is.
   *
   * @param texture the picture
   * @param opacity 0 to 1
   * @return the material
   */
  public static Material picture(Texture texture, double opacity) {
    return new Material(Rgba.WHITE.withAlpha(opacity), false, Optional.of(texture), Depth.TESTED);
  }

  /**
   * The same, seen through everything.
   *
   * @return the material
   */
  public Material onTop() {
    return new Material(color, lit, texture, Depth.ON_TOP, pale);
  }

  /**
   * The same, as it looks when it is of the past.
   *
   * @param share of the background, 0 to 1
   * @return the material
   */
  public Material paled(float share) {
    return new Material(color, lit, texture, depth, share);
  }
}
