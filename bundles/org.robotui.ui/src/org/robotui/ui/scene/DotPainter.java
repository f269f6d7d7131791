package org.robotui.ui.scene;

import org.eclipse.swt.graphics.GC;

/**
 * Draws many small dots as cheaply as they can be: two crossed rectangles look round at this size and cost a tenth of an
 * antialiased circle; dots that cannot be seen, or lie on the one before, are skipped.
 */
final class DotPainter {
  private DotPainter() {}

  static void paint(GC gc, Viewport viewport, double[] xy, int count, double diameter) {
    int size = Math.max(2, (int) Math.round(diameter));
    int thick = size < 4 ? size : size / 2;
    int lastX = Integer.MIN_VALUE;
    int lastY = Integer.MIN_VALUE;
    for (int i = 0; i < count; i++) {
      double x = viewport.pixelX(xy[2 * i]);
      double y = viewport.pixelY(xy[2 * i + 1]);
      if (!seen(viewport, x, y, size)) {
        continue;
      }
      int left = (int) Math.round(x - size / 2.0);
      int top = (int) Math.round(y - size / 2.0);
      if (left != lastX || top != lastY) {
        dot(gc, left, top, size, thick);
        lastX = left;
        lastY = top;
      }
    }
  }

  private static void dot(GC gc, int left, int top, int size, int thick) {
    int inset = (size - thick) / 2;
    gc.fillRectangle(left, top + inset, size, thick);
    if (thick < size) {
      gc.fillRectangle(left + inset, top, thick, inset);
      gc.fillRectangle(left + inset, top + inset + thick, thick, size - inset - thick);
    }
  }

  private static boolean seen(Viewport viewport, double x, double y, double margin) {
    return x > -margin && y > -margin && x < viewport.width() + margin && y < viewport.height() + margin;
  }
}
