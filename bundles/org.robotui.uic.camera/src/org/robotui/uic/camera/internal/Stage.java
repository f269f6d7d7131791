package org.robotui.uic.camera.internal;

import org.eclipse.swt.graphics.Rectangle;

/**
 * Where a picture is shown.
 *
 * @param area of the view, points
 * @param width of the picture, pixels
 * @param height of the picture, pixels
 * @param dot edge of a pixel of the screen, points
 */
record Stage(Rectangle area, int width, int height, double dot) {
  private static final double CLOSEST = 64;

  /** Points a pixel of the picture when nobody has zoomed. */
  double base(ZoomMode mode) {
    return switch (mode) {
      case FIT -> fit();
      case FILL -> Math.max((double) area.width / width, (double) area.height / height);
      case ACTUAL -> dot;
    };
  }

  /** Points a pixel at least. */
  double least() {
    return Math.min(fit(), dot);
  }

  /** Points a pixel at most. */
  double most() {
    return Math.max(CLOSEST, 2 * Math.max((double) area.width / width, (double) area.height / height));
  }

  private double fit() {
    return Math.min((double) area.width / width, (double) area.height / height);
  }
}
