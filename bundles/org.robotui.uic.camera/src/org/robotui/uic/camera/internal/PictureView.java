package org.robotui.uic.camera.internal;

import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;

/**
 * Which part of a picture is seen: pure, and independent of the sizes of picture and window, so that it stays when these
 * change.
 *
 * @param zoom 1 shows all of it
 * @param x what lies in the middle, as a share of the width
 * @param y what lies in the middle, as a share of the height
 */
record PictureView(double zoom, double x, double y) {
  static final PictureView FIT = new PictureView(1, 0.5, 0.5);

  private static final double CLOSEST = 64;

  PictureView {
    zoom = Math.clamp(zoom, 1, CLOSEST);
    double half = 0.5 / zoom;
    x = Math.clamp(x, half, 1 - half);
    y = Math.clamp(y, half, 1 - half);
  }

  /** Where the picture lies in a window, its aspect kept. */
  Placement in(Rectangle area, int width, int height) {
    double scale = zoom * Math.min((double) area.width / width, (double) area.height / height);
    return new Placement(area.x + area.width / 2.0 - x * width * scale, area.y + area.height / 2.0 - y * height * scale, scale);
  }

  /** Zooms so that what lies at a point of the window stays there. */
  PictureView zoomed(double factor, Point at, Rectangle area, int width, int height) {
    Placement now = in(area, width, height);
    double pixelX = (at.x - now.left) / now.scale;
    double pixelY = (at.y - now.top) / now.scale;
    double scale = now.scale * (Math.clamp(zoom * factor, 1, CLOSEST) / zoom);
    return new PictureView(zoom * factor, (pixelX + (area.x + area.width / 2.0 - at.x) / scale) / width,
        (pixelY + (area.y + area.height / 2.0 - at.y) / scale) / height);
  }

  /** Moves the picture with the hand. */
  PictureView moved(int dx, int dy, Rectangle area, int width, int height) {
    double scale = in(area, width, height).scale;
    return new PictureView(zoom, x - dx / (scale * width), y - dy / (scale * height));
  }

  /**
   * Where a picture lies.
   *
   * @param left its left edge in the window
   * @param top its top edge
   * @param scale points a pixel
   */
  record Placement(double left, double top, double scale) {
    Rectangle bounds(int width, int height) {
      int x = (int) Math.round(left);
      int y = (int) Math.round(top);
      return new Rectangle(x, y, (int) Math.max(1, Math.round(left + width * scale) - x),
          (int) Math.max(1, Math.round(top + height * scale) - y));
    }

    /** The pixel under a point; may lie outside the picture. */
    Point pixel(int x, int y) {
      return new Point((int) Math.floor((x - left) / scale), (int) Math.floor((y - top) / scale));
    }
  }
}
