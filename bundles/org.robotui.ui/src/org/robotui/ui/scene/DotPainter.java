package org.robotui.ui.scene;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Path;

/**
 * Draws many small dots as cheaply as they can be: two crossed rectangles look round at this size and cost a tenth of
 * an antialiased circle; dots that cannot be seen, or lie on the one before, are skipped. What remains is filled in few
 * calls, since a call costs more than a dot.
 */
final class DotPainter {
  /** So many in one call: the platform's effort grows faster than their number. */
  private static final int MOST = 1024;

  private DotPainter() {}

  static void paint(GC gc, Viewport viewport, double[] xy, int count, double diameter) {
    int size = Math.max(2, (int) Math.round(diameter));
    int thick = size < 4 ? size : size / 2;
    int lastX = Integer.MIN_VALUE;
    int lastY = Integer.MIN_VALUE;
    Path path = new Path(gc.getDevice());
    int gathered = 0;
    for (int i = 0; i < count; i++) {
      double x = viewport.pixelX(xy[2 * i]);
      double y = viewport.pixelY(xy[2 * i + 1]);
      if (!seen(viewport, x, y, size)) {
        continue;
      }
      int left = (int) Math.round(x - size / 2.0);
      int top = (int) Math.round(y - size / 2.0);
      if (left != lastX || top != lastY) {
        dot(path, left, top, size, thick);
        if (++gathered == MOST) {
          fill(gc, path);
          path = new Path(gc.getDevice());
          gathered = 0;
        }
        lastX = left;
        lastY = top;
      }
    }
    fill(gc, path);
  }

  private static void fill(GC gc, Path path) {
    gc.setFillRule(SWT.FILL_WINDING);
    gc.fillPath(path);
    path.dispose();
  }

  private static void dot(Path path, int left, int top, int size, int thick) {
    int inset = (size - thick) / 2;
    path.addRectangle(left, top + inset, size, thick);
    if (thick < size) {
      path.addRectangle(left + inset, top, thick, size);
    }
  }

  private static boolean seen(Viewport viewport, double x, double y, double margin) {
    return x > -margin && y > -margin && x < viewport.width() + margin && y < viewport.height() + margin;
  }
}
