package org.robotui.entity.gps;

import org.eclipse.swt.graphics.Path;
import org.robotui.ui.scene.Painter;
import org.robotui.ui.scene.Viewport;

/** Draws a part of a long way: points on the same pixel once, and nothing of what lies outside the window. */
final class WayLine {
  private static final double LEAST = 1.5;
  /** The toolkit's numbers end at some millions of pixels. */
  private static final double FAR = 20_000;

  private final Viewport viewport;
  private final Path path;
  private double lastX;
  private double lastY;
  private boolean pen;

  private WayLine(Viewport viewport, Path path) {
    this.viewport = viewport;
    this.path = path;
  }

  /** From one point to another, both included. */
  static void paint(Painter painter, double[] xy, int from, int to) {
    Path path = new Path(painter.gc().getDevice());
    new WayLine(painter.viewport(), path).run(xy, from, to);
    painter.gc().drawPath(path);
    path.dispose();
  }

  private void run(double[] xy, int from, int to) {
    lastX = viewport.pixelX(xy[2 * from]);
    lastY = viewport.pixelY(xy[2 * from + 1]);
    for (int i = from + 1; i <= to; i++) {
      double x = viewport.pixelX(xy[2 * i]);
      double y = viewport.pixelY(xy[2 * i + 1]);
      if (Math.abs(x - lastX) + Math.abs(y - lastY) >= LEAST || i == to) {
        step(x, y);
      }
    }
  }

  private void step(double x, double y) {
    boolean seen = Math.max(x, lastX) >= 0 && Math.min(x, lastX) <= viewport.width()
        && Math.max(y, lastY) >= 0 && Math.min(y, lastY) <= viewport.height();
    if (seen) {
      if (!pen) {
        path.moveTo(near(lastX), near(lastY));
      }
      path.lineTo(near(x), near(y));
    }
    pen = seen;
    lastX = x;
    lastY = y;
  }

  private static float near(double pixel) {
    return (float) Math.clamp(pixel, -FAR, FAR);
  }
}
