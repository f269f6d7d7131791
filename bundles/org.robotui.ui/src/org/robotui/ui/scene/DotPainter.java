package org.robotui.ui.scene;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Path;

/** Draws many small dots as cheaply as they can be: in one path per some hundred, skipping those that cannot be seen. */
final class DotPainter {
  private static final int PER_PATH = 256;
  private static final int FULL_TURN = 360;

  private DotPainter() {}

  static void paint(GC gc, Viewport viewport, double[] xy, int count, double diameter) {
    Path path = new Path(gc.getDevice());
    // Overlapping dots must not cut holes into each other.
    gc.setFillRule(SWT.FILL_WINDING);
    int inPath = 0;
    double lastX = Double.NaN;
    double lastY = Double.NaN;
    for (int i = 0; i < count; i++) {
      double x = viewport.pixelX(xy[2 * i]);
      double y = viewport.pixelY(xy[2 * i + 1]);
      boolean same = Math.abs(x - lastX) < 0.5 && Math.abs(y - lastY) < 0.5;
      if (same || !seen(viewport, x, y, diameter)) {
        continue;
      }
      dot(path, x, y, diameter);
      lastX = x;
      lastY = y;
      if (++inPath == PER_PATH) {
        gc.fillPath(path);
        path.dispose();
        path = new Path(gc.getDevice());
        inPath = 0;
      }
    }
    gc.fillPath(path);
    path.dispose();
  }

  private static boolean seen(Viewport viewport, double x, double y, double margin) {
    return x > -margin && y > -margin && x < viewport.width() + margin && y < viewport.height() + margin;
  }

  private static void dot(Path path, double x, double y, double diameter) {
    float left = (float) (x - diameter / 2);
    float top = (float) (y - diameter / 2);
    float size = (float) diameter;
    path.moveTo(left + size, top + size / 2);
    path.addArc(left, top, size, size, 0, FULL_TURN);
    path.close();
  }
}
