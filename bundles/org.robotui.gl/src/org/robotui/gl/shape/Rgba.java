package org.robotui.gl.shape;

/**
 * A colour, not premultiplied, sRGB.
 *
 * @param red 0 to 1
 * @param green 0 to 1
 * @param blue 0 to 1
 * @param alpha 0 invisible to 1 opaque
 */
public record Rgba(float red, float green, float blue, float alpha) {
  /** Opaque white, which leaves the colours of points and textures as they are. */
  public static final Rgba WHITE = new Rgba(1, 1, 1, 1);

  /**
   * Brings what is no number to 0 and the rest into the range.
   *
   * @param red 0 to 1
   * @param green 0 to 1
   * @param blue 0 to 1
   * @param alpha 0 to 1
   */
  public Rgba {
    red = part(red);
    green = part(green);
    blue = part(blue);
    alpha = part(alpha);
  }

  /**
   * An opaque colour.
   *
   * @param rgb red in bits 16 to 23, green in 8 to 15, blue in 0 to 7
   * @return the colour
   */
  public static Rgba of(int rgb) {
    return new Rgba((rgb >> 16 & 0xff) / 255f, (rgb >> 8 & 0xff) / 255f, (rgb & 0xff) / 255f, 1);
  }

  /**
   * The same colour, more or less transparent.
   *
   * @param opacity takes the place of alpha
   * @return the colour
   */
  public Rgba withAlpha(double opacity) {
    return new Rgba(red, green, blue, (float) opacity);
  }

  /**
   * The colour as the four bytes red, green, blue, alpha that shapes keep per point.
   *
   * @return red in bits 24 to 31, alpha in 0 to 7
   */
  public int packed() {
    return Math.round(red * 255) << 24 | Math.round(green * 255) << 16 | Math.round(blue * 255) << 8
        | Math.round(alpha * 255);
  }

  private static float part(float value) {
    return Float.isNaN(value) ? 0 : Math.clamp(value, 0, 1);
  }
}
