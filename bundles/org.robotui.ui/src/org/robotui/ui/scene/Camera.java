package org.robotui.ui.scene;

import java.util.Optional;
import org.robotui.geometry.Vector3;

/**
 * Where the user looks. Until the user moves the view it shows all there is; afterwards only hands and following move
 * it. Display thread.
 */
public final class Camera {
  private static final double START_SCALE = 40;
  private static final int LEAST_SHARE = 4;

  private final double largestFit;
  private final int margin;
  private Viewport viewport;
  private boolean touched;

  /**
   * A camera over the origin.
   *
   * @param largestFit how close it comes by itself, pixels per metre
   * @param margin left free around what it shows by itself, pixels; less in small windows
   */
  public Camera(double largestFit, int margin) {
    this.margin = margin;
    this.largestFit = largestFit;
    this.viewport = new Viewport(0, 0, Math.min(START_SCALE, largestFit), 1, 1);
  }

  /**
   * What is seen.
   *
   * @return as of the last call of any method here
   */
  public Viewport viewport() {
    return viewport;
  }

  /**
   * Prepares for the next paint.
   *
   * @param width of the window, pixels
   * @param height of the window, pixels
   * @param content what there is to see
   * @param followed what stays in the middle
   */
  public void settle(int width, int height, Optional<Bounds> content, Optional<Vector3> followed) {
    boolean sized = viewport.width() != Math.max(1, width) || viewport.height() != Math.max(1, height);
    viewport = viewport.resized(width, height);
    if (!touched) {
      content.filter(b -> sized || !inside(b)).ifPresent(this::show);
    }
    followed.ifPresent(p -> viewport = viewport.centeredAt(p.x(), p.y()));
  }

  /**
   * Shows all, and goes on to do so until it is moved.
   *
   * @param content what there is to see
   */
  public void fit(Optional<Bounds> content) {
    touched = false;
    content.ifPresent(this::show);
  }

  /**
   * Moves the content with the hand.
   *
   * @param dx pixels to the right
   * @param dy pixels down
   */
  public void pan(double dx, double dy) {
    touched = true;
    viewport = viewport.panned(dx, dy);
  }

  /**
   * Zooms; what lies at the pixel stays there.
   *
   * @param pixelX from the left
   * @param pixelY from the top
   * @param factor above 1 to come closer
   */
  public void zoom(double pixelX, double pixelY, double factor) {
    touched = true;
    viewport = viewport.zoomedAt(pixelX, pixelY, factor);
  }

  /**
   * Puts a point in the middle.
   *
   * @param x metres
   * @param y metres
   */
  public void center(double x, double y) {
    touched = true;
    viewport = viewport.centeredAt(x, y);
  }

  private boolean inside(Bounds b) {
    Bounds seen = viewport.visible();
    return seen.contains(b.minX(), b.minY()) && seen.contains(b.maxX(), b.maxY());
  }

  private void show(Bounds bounds) {
    viewport = viewport.fitting(bounds, Math.min(margin, Math.min(viewport.width(), viewport.height()) / LEAST_SHARE));
    if (viewport.scale() > largestFit) {
      viewport = new Viewport(
          viewport.centerX(), viewport.centerY(), largestFit, viewport.width(), viewport.height());
    }
  }
}
