package org.robotui.uic.gps.internal.view;

import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceActions;

/** What the title line offers. */
public final class GpsActions {
  private GpsActions() {}

  /** Adds all of them. */
  public static void offer(SurfaceActions<GpsCanvas> to) {
    to.switched("follow", "Follow the receiver (F)", Icon.FOLLOW, GpsCanvas::following, GpsCanvas::toggleFollow)
        .action("fit", "Show all (0)", Icon.FIT, c -> c.mover().fit())
        .switched("measure", "Measure between two clicks (M)", Icon.RULER, GpsCanvas::measuring, GpsCanvas::toggleRuler)
        .action("copy", "Copy the coordinates (C)", Icon.COPY, GpsCanvas::copy)
        .switched("layers", "Layers (L)", Icon.LAYERS, GpsCanvas::listOpen, GpsCanvas::toggleList)
        .action("options", "What is shown", Icon.MORE, GpsCanvas::openMenu);
  }
}
