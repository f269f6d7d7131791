package org.robotui.entity.grid;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.scene.Viewport;

/** A bar of a round length with that length above it, in the lower right corner. */
public final class ScaleBar {
  private static final double LEAST_PIXELS = 80;
  private static final int BOTTOM = 24;
  private static final int RIGHT = 28;

  private ScaleBar() {}

  /**
   * Paints. Display thread.
   *
   * @param gc where, in pixels
   * @param theme colours and fonts
   * @param viewport metres to pixels
   */
  public static void paint(GC gc, Theme theme, Viewport viewport) {
    double length = GridSteps.atLeast(viewport.scale(), LEAST_PIXELS);
    int pixels = (int) Math.round(length * viewport.scale());
    int right = viewport.width() - RIGHT;
    int bottom = viewport.height() - BOTTOM;
    gc.setAlpha(255);
    gc.setForeground(theme.color(Role.TEXT));
    gc.setLineWidth(2);
    gc.setLineCap(SWT.CAP_FLAT);
    gc.drawLine(right - pixels, bottom, right, bottom);
    gc.setFont(theme.font(Face.SMALL));
    String label = GridSteps.label(length);
    Point size = gc.textExtent(label);
    gc.drawText(label, right - pixels / 2 - size.x / 2, bottom - size.y - 3, true);
  }
}
