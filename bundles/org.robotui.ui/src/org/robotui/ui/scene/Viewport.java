package org.robotui.ui.scene;

/**
 * What part of the plane is seen: world metres with y up to pixels with y down. Immutable.
 *
 * @param centerX world x in the middle of the window, metres
 * @param centerY world y in the middle of the window, metres
 * @param scale pixels per metre
 * @param width of the window, pixels
 * @param height of the window, pixels
 */
public record Viewport(double centerX, double centerY, double scale, int width, int height) {
  /** The smallest scale: a kilometre in ten pixels. */
  public static final double MIN_SCALE = 0.01;

  /** The largest scale: a millimetre in ten pixels. */
  public static final double MAX_SCALE = 10_000;

  private static final double SMALLEST_EXTENT = 0.1;
  /** Farther out, metres, nothing is looked at: nor do numbers tell pixels apart there. */
  private static final double FARTHEST = 1e10;

  /**
   * Keeps centre and scale within their limits.
   *
   * @param centerX metres
   * @param centerY metres
   * @param scale pixels per metre
   * @param width pixels
   * @param height pixels
   */
  public Viewport {
    if (Double.isNaN(centerX) || Double.isNaN(centerY) || Double.isNaN(scale)) {
      throw new IllegalArgumentException("no view: centre " + centerX + ", " + centerY + ", scale " + scale);
    }
    centerX = near(centerX);
    centerY = near(centerY);
    scale = Math.clamp(scale, MIN_SCALE, MAX_SCALE);
    width = Math.max(1, width);
    height = Math.max(1, height);
  }

  /**
   * Where a world x lies.
   *
   * @param worldX metres
   * @return pixels from the left
   */
  public double pixelX(double worldX) {
    return width / 2.0 + (worldX - centerX) * scale;
  }

  /**
   * Where a world y lies.
   *
   * @param worldY metres
   * @return pixels from the top
   */
  public double pixelY(double worldY) {
    return height / 2.0 - (worldY - centerY) * scale;
  }

  /**
   * What lies at a pixel.
   *
   * @param pixelX from the left
   * @return world x, metres
   */
  public double worldX(double pixelX) {
    return centerX + (pixelX - width / 2.0) / scale;
  }

  /**
   * What lies at a pixel.
   *
   * @param pixelY from the top
   * @return world y, metres
   */
  public double worldY(double pixelY) {
    return centerY - (pixelY - height / 2.0) / scale;
  }

  /**
   * Moves the content with the hand.
   *
   * @param dx pixels to the right
   * @param dy pixels down
   * @return the view after that
   */
  public Viewport panned(double dx, double dy) {
    return new Viewport(centerX - dx / scale, centerY + dy / scale, scale, width, height);
  }

  /**
   * Zooms; what lies at the pixel stays there.
   *
   * @param pixelX from the left
   * @param pixelY from the top
   * @param factor above 1 to come closer
   * @return the view after that
   */
  public Viewport zoomedAt(double pixelX, double pixelY, double factor) {
    double target = Math.clamp(scale * factor, MIN_SCALE, MAX_SCALE);
    double x = worldX(pixelX) - (pixelX - width / 2.0) / target;
    double y = worldY(pixelY) + (pixelY - height / 2.0) / target;
    return new Viewport(x, y, target, width, height);
  }

  /**
   * Puts a point in the middle.
   *
   * @param x metres
   * @param y metres
   * @return the view after that, with the same scale
   */
  public Viewport centeredAt(double x, double y) {
    return new Viewport(x, y, scale, width, height);
  }

  /**
   * Takes the size of a window; the middle stays.
   *
   * @param newWidth pixels
   * @param newHeight pixels
   * @return the view after that
   */
  public Viewport resized(int newWidth, int newHeight) {
    return new Viewport(centerX, centerY, scale, newWidth, newHeight);
  }

  /**
   * Shows all of a rectangle.
   *
   * @param bounds what to show
   * @param margin pixels left free at each side
   * @return the view after that
   */
  public Viewport fitting(Bounds bounds, int margin) {
    Bounds near = new Bounds(near(bounds.minX()), near(bounds.minY()), near(bounds.maxX()), near(bounds.maxY()));
    double across = Math.max(1, width - 2.0 * margin) / Math.max(SMALLEST_EXTENT, near.width());
    double down = Math.max(1, height - 2.0 * margin) / Math.max(SMALLEST_EXTENT, near.height());
    return new Viewport((near.minX() + near.maxX()) / 2, (near.minY() + near.maxY()) / 2, Math.min(across, down), width,
        height);
  }

  private static double near(double coordinate) {
    return Math.clamp(coordinate, -FARTHEST, FARTHEST);
  }

  /**
   * What is seen.
   *
   * @return the window in the world
   */
  public Bounds visible() {
    return new Bounds(worldX(0), worldY(height), worldX(width), worldY(0));
  }
}
