package org.robotui.uic.camera.internal;

import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;

/**
 * Where a picture lies.
 *
 * @param left its left edge in the window, points
 * @param top its top edge
 * @param scale points a pixel
 */
record Placement(double left, double top, double scale) {
  Rectangle bounds(int width, int height) {
    return region(0, 0, width, height);
  }

  /** Where a block of pixels lies. */
  Rectangle region(int x, int y, int width, int height) {
    int fromX = (int) Math.round(left + x * scale);
    int fromY = (int) Math.round(top + y * scale);
    return new Rectangle(fromX, fromY, (int) Math.max(1, Math.round(left + (x + width) * scale) - fromX),
        (int) Math.max(1, Math.round(top + (y + height) * scale) - fromY));
  }

  /** The pixels that are seen in an area, as few as there need be. */
  Rectangle seen(Rectangle area, int width, int height) {
    int fromX = Math.clamp((long) Math.floor((area.x - left) / scale), 0, width - 1);
    int fromY = Math.clamp((long) Math.floor((area.y - top) / scale), 0, height - 1);
    int toX = Math.clamp((long) Math.ceil((area.x + area.width - left) / scale), fromX + 1, width);
    int toY = Math.clamp((long) Math.ceil((area.y + area.height - top) / scale), fromY + 1, height);
    return new Rectangle(fromX, fromY, toX - fromX, toY - fromY);
  }

  /** The pixel under a point; may lie outside the picture. */
  Point pixel(int x, int y) {
    return new Point((int) Math.floor((x - left) / scale), (int) Math.floor((y - top) / scale));
  }
}
