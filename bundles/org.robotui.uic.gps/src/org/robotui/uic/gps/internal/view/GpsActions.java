package org.robotui.uic.gps.internal.view;

import java.util.List;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceActions;
import org.robotui.ui.ViewAction;

/** What the title line offers: the same objects for every control that is made. Display thread. */
public final class GpsActions {
  private final SurfaceActions<GpsCanvas> made = new SurfaceActions<>();
  private final List<ViewAction> all = List.of(
      made.switched("follow", "Follow the receiver (F)", Icon.FOLLOW, GpsCanvas::following, GpsCanvas::toggleFollow),
      made.action("fit", "Show all (0)", Icon.FIT, c -> c.mover().fit()),
      made.switched("measure", "Measure between two clicks (M)", Icon.RULER, GpsCanvas::measuring,
          GpsCanvas::toggleRuler),
      made.action("copy", "Copy the coordinates (C)", Icon.COPY, GpsCanvas::copy),
      made.switched("layers", "Layers (L)", Icon.LAYERS, GpsCanvas::listOpen, GpsCanvas::toggleList),
      made.action("options", "What is shown", Icon.MORE, GpsCanvas::openMenu));

  /** All actions. */
  public List<ViewAction> all() {
    return all;
  }

  void connect(GpsCanvas shown) {
    made.connect(shown);
  }

  void disconnect(GpsCanvas gone) {
    made.disconnect(gone);
  }
}
