package org.robotui.uic.plot.internal.view;

import java.time.ZoneOffset;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.time.PointedTime;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.TimeView;

/** A canvas that shows one scene, without a robot behind it. */
public final class PlotScreen {
  private final PlotScene scene;
  private final PlotState state = new PlotState(new PointedTime());
  private final PaintedCanvas canvas;

  public PlotScreen(Composite parent, Theme theme, PlotScene scene) {
    this.scene = scene;
    PlotPainter painter = new PlotPainter(theme, ZoneOffset.UTC);
    this.canvas = new PaintedCanvas(parent, theme, (gc, area) -> painter.paint(gc, area, scene, state));
  }

  public PaintedCanvas canvas() {
    return canvas;
  }

  /** Changes what of the time is seen. */
  public void look(TimeView view) {
    state.time(scene, 0, view);
  }
}
