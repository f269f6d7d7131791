package org.robotui.entity.grid.internal.layer;

import java.util.Optional;
import org.robotui.entity.grid.GridEntity;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.LayerResult;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerTick;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Ink;
import org.robotui.ui.scene.Painter;

/** A grid at round distances of whatever is seen. */
final class GridLayer implements DataLayer {
  private final GridEntity grid = new GridEntity();
  private Ink ink = Ink.USUAL;

  @Override
  public LayerResult update(LayerTick tick) {
    boolean changed = !tick.ink().equals(ink);
    ink = tick.ink();
    grid.ink(ink);
    return new LayerResult(changed, new LayerStatus.Shown(""));
  }

  @Override
  public void paint(Painter painter) {
    grid.paint(painter);
  }

  @Override
  public Optional<Bounds> bounds() {
    return grid.bounds();
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return grid.describeAt(x, y, tolerance);
  }
}
