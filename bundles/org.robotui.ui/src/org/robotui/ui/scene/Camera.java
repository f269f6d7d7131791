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
  /** What is seen first, such as the robot, may lie beside what the user looked at, until the map is there. */
  private static final long COMES_NANOS = 5_000_000_000L;

  private final double largestFit;
  private final int margin;
  private Viewport viewport;
  private final Optional<KeptViewport> kept;
  private boolean touched;
  /**
   * Since when there is something to see, while it is not certain that any of it is seen from where the camera was
   * left.
   */
  private Optional<Long> doubtedNanos = Optional.empty();
  private boolean doubted;

  /**
   * A camera over the origin.
   *
   * @param largestFit how close it comes by itself, pixels per metre
   * @param margin left free around what it shows by itself, pixels; less in small windows
   */
  public Camera(double largestFit, int margin) {
    this(largestFit, margin, Optional.empty());
  }

  /**
   * A camera where the user left it. Where nothing of what there is can be seen from there, since the robot is in
   * another place this time, it shows all there is after some seconds.
   *
   * @param largestFit how close it comes by itself, pixels per metre
   * @param margin left free around what it shows by itself, pixels; less in small windows
   * @param kept where it was left
   */
  public Camera(double largestFit, int margin, KeptViewport kept) {
    this(largestFit, margin, Optional.of(kept));
  }

  private Camera(double largestFit, int margin, Optional<KeptViewport> kept) {
    this.margin = margin;
    this.largestFit = largestFit;
    this.kept = kept;
    Viewport start = new Viewport(0, 0, Math.min(START_SCALE, largestFit), 1, 1);
    Optional<Viewport> left = kept.flatMap(k -> k.read(start));
    viewport = left.orElse(start);
    touched = left.isPresent();
    doubted = touched;
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
    if (doubted) {
      content.ifPresent(this::doubt);
    }
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
    showsAll();
    content.ifPresent(this::show);
  }

  /**
   * Shows all of something, and stays there.
   *
   * @param bounds how far it reaches
   */
  public void fitTo(Bounds bounds) {
    show(bounds);
    byHand();
  }

  /**
   * Moves the content with the hand.
   *
   * @param dx pixels to the right
   * @param dy pixels down
   */
  public void pan(double dx, double dy) {
    viewport = viewport.panned(dx, dy);
    byHand();
  }

  /**
   * Zooms; what lies at the pixel stays there.
   *
   * @param pixelX from the left
   * @param pixelY from the top
   * @param factor above 1 to come closer
   */
  public void zoom(double pixelX, double pixelY, double factor) {
    viewport = viewport.zoomedAt(pixelX, pixelY, factor);
    byHand();
  }

  /**
   * Puts a point in the middle.
   *
   * @param x metres
   * @param y metres
   */
  public void center(double x, double y) {
    viewport = viewport.centeredAt(x, y);
    byHand();
  }

  private void byHand() {
    touched = true;
    doubted = false;
    kept.ifPresent(k -> k.moved(viewport));
  }

  private void showsAll() {
    touched = false;
    doubted = false;
    kept.ifPresent(KeptViewport::forget);
  }

  private void doubt(Bounds content) {
    long now = kept.map(KeptViewport::nanos).orElse(0L);
    doubted = !viewport.visible().intersects(content);
    long since = doubtedNanos.orElse(now);
    doubtedNanos = Optional.of(since);
    if (doubted && now - since > COMES_NANOS) {
      showsAll();
    }
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
