package org.robotui.uic.map.internal.view;

import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceActions;

/** What the title line offers. */
public final class MapActions {
  static final String MEASURE = "measure";
  static final String GOAL = "goal";
  static final String POSE = "initial_pose";

  private MapActions() {}

  /** Adds all of them; {@code reset} has what belongs to the time before forgotten. */
  public static void offer(SurfaceActions<MapCanvas> to, Runnable reset) {
    to.switched("follow", "Follow the robot (F)", Icon.FOLLOW, MapCanvas::following, MapCanvas::toggleFollow)
        .action("fit", "Show all (0)", Icon.FIT, c -> c.mover().fit());
    tool(to, MEASURE, "Measure (M)", Icon.RULER);
    tool(to, GOAL, "Send a goal (G)", Icon.TARGET);
    tool(to, POSE, "Pose estimate (P)", Icon.POSE);
    to.add("reset", "Reset: forget transforms and trails", Icon.RESTART, reset)
        .switched("layers", "Layers (L)", Icon.LAYERS, MapCanvas::listOpen, MapCanvas::toggleList);
  }

  private static void tool(SurfaceActions<MapCanvas> to, String id, String label, Icon icon) {
    to.switched(id, label, icon, c -> c.using(id), c -> c.toggleTool(id));
  }
}
