package org.robotui.uic.scene3d.internal.view;

import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceActions;

/** What the title line offers. */
public final class SceneActions {
  private SceneActions() {}

  /** Adds all of them; {@code reset} has what belongs to the time before forgotten. */
  public static void offer(SurfaceActions<SceneSurface> to, Runnable reset) {
    to.switched("follow", "Follow a frame\u2026", Icon.FOLLOW, SceneSurface::following,
        s -> s.menus().follow(s.canvas()))
        .action("fit", "Show all (0)", Icon.FIT, SceneSurface::fit)
        .action("camera", "Camera and views (V)", Icon.EYE, s -> s.menus().camera(s.canvas()));
    tool(to, ToolKind.MEASURE, Icon.RULER);
    tool(to, ToolKind.GOAL, Icon.TARGET);
    tool(to, ToolKind.POSE, Icon.POSE);
    tool(to, ToolKind.WAYPOINTS, Icon.ROUTE);
    to.add("reset", "Reset: forget transforms and trails", Icon.RESTART, reset)
        .action("screenshot", "Save a picture\u2026", Icon.CAMERA, s -> s.menus().screenshot(s.canvas()))
        .switched("displays", "Displays (L)", Icon.LAYERS, SceneSurface::treeOpen, SceneSurface::toggleTree);
  }

  private static void tool(SurfaceActions<SceneSurface> to, ToolKind kind, Icon icon) {
    to.switched(kind.id(), kind.label(), icon, s -> s.tools().using(kind), s -> s.tools().toggle(kind));
  }
}
