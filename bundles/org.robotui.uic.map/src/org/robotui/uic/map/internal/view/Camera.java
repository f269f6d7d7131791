package org.robotui.uic.map.internal.view;

import java.util.Optional;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Viewport;

/**
 * Where the user looks. Until the user moves the map it shows all there is; afterwards only hands and following move it.
 */
final class Camera {
  private static final double START_SCALE = 40;
  private static final double LARGEST_FIT = 200;
  private static final int MARGIN = 48;

  private Viewport viewport = new Viewport(0, 0, START_SCALE, 1, 1);
  private boolean touched;

  Viewport viewport() {
    return viewport;
  }

  /** For the next paint. */
  void settle(int width, int height, Optional<Bounds> content, Optional<Vector3> followed) {
    boolean sized = viewport.width() != Math.max(1, width) || viewport.height() != Math.max(1, height);
    viewport = viewport.resized(width, height);
    if (!touched) {
      content.filter(b -> sized || !inside(b)).ifPresent(this::show);
    }
    followed.ifPresent(p -> viewport = viewport.centeredAt(p.x(), p.y()));
  }

  void fit(Optional<Bounds> content) {
    touched = false;
    content.ifPresent(this::show);
  }

  void pan(double dx, double dy) {
    touched = true;
    viewport = viewport.panned(dx, dy);
  }

  void zoom(double pixelX, double pixelY, double factor) {
    touched = true;
    viewport = viewport.zoomedAt(pixelX, pixelY, factor);
  }

  void center(double x, double y) {
    touched = true;
    viewport = viewport.centeredAt(x, y);
  }

  private boolean inside(Bounds b) {
    Bounds seen = viewport.visible();
    return seen.contains(b.minX(), b.minY()) && seen.contains(b.maxX(), b.maxY());
  }

  private void show(Bounds bounds) {
    viewport = viewport.fitting(bounds, MARGIN);
    if (viewport.scale() > LARGEST_FIT) {
      viewport = new Viewport(
          viewport.centerX(), viewport.centerY(), LARGEST_FIT, viewport.width(), viewport.height());
    }
  }
}
