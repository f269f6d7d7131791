package org.robotui.entity.grid;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Ink;
import org.robotui.ui.scene.Painter;
import org.robotui.ui.scene.Viewport;

/** Lines at round distances, quiet enough to lie below everything, and the axes a little stronger. */
public final class GridEntity implements Entity {
  private static final double LEAST_PIXELS = 44;
  private static final double QUIET = 0.55;

  private volatile Ink ink = Ink.USUAL;

  /** A grid. */
  public GridEntity() {
    // Nothing to prepare: it depends on the viewport alone.
  }

  /**
   * The colour. Any thread.
   *
   * @param chosen that of lines at the beginning
   */
  public void ink(Ink chosen) {
    ink = chosen;
  }

  @Override
  public void paint(Painter painter) {
    Viewport viewport = painter.viewport();
    double step = GridSteps.atLeast(viewport.scale(), LEAST_PIXELS);
    Bounds seen = viewport.visible();
    GC gc = painter.gc();
    // Lines along the axes are sharp on whole pixels without antialiasing.
    gc.setAntialias(SWT.OFF);
    painter.width(1).stroke(ink.of(painter.theme(), Role.LINE));
    for (double x : GridSteps.within(seen.minX(), seen.maxX(), step)) {
      int pixel = (int) Math.round(viewport.pixelX(x));
      painter.opacity(x == 0 ? 1 : QUIET);
      gc.drawLine(pixel, 0, pixel, viewport.height());
    }
    for (double y : GridSteps.within(seen.minY(), seen.maxY(), step)) {
      int pixel = (int) Math.round(viewport.pixelY(y));
      painter.opacity(y == 0 ? 1 : QUIET);
      gc.drawLine(0, pixel, viewport.width(), pixel);
    }
    painter.opacity(1);
    gc.setAntialias(SWT.ON);
  }

  @Override
  public Optional<Bounds> bounds() {
    return Optional.empty();
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return Optional.empty();
  }
}
