package org.robotui.uic.map.internal.view;

import java.util.List;
import java.util.Optional;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceActions;
import org.robotui.ui.ViewAction;

/** What the title line offers: the same objects for every control that is made. Display thread. */
public final class MapActions {
  static final String MEASURE = "measure";
  static final String GOAL = "goal";
  static final String POSE = "initial_pose";

  private final SurfaceActions<MapCanvas> made = new SurfaceActions<>();
  private final List<ViewAction> all;

  /**
   * The actions of a view.
   *
   * @param reset has what belongs to the time before forgotten
   */
  public MapActions(Runnable reset) {
    all = List.of(
        made.switched("follow", "Follow the robot (F)", Icon.FOLLOW, MapCanvas::following, MapCanvas::toggleFollow),
        made.action("fit", "Show all (0)", Icon.FIT, c -> c.mover().fit()),
        tool(MEASURE, "Measure (M)", Icon.RULER),
        tool(GOAL, "Send a goal (G)", Icon.TARGET),
        tool(POSE, "Pose estimate (P)", Icon.POSE),
        new ViewAction("reset", "Reset: forget transforms and trails", Icon.RESTART.id(), Optional.empty(), reset),
        made.switched("layers", "Layers (L)", Icon.LAYERS, MapCanvas::listOpen, MapCanvas::toggleList));
  }

  /** All actions. */
  public List<ViewAction> all() {
    return all;
  }

  void connect(MapCanvas shown) {
    made.connect(shown);
  }

  void disconnect(MapCanvas gone) {
    made.disconnect(gone);
  }

  private ViewAction tool(String id, String label, Icon icon) {
    return made.switched(id, label, icon, c -> c.using(id), c -> c.toggleTool(id));
  }
}
