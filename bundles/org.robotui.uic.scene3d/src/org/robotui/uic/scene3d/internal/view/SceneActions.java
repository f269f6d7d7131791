package org.robotui.uic.scene3d.internal.view;

import java.util.List;
import java.util.Optional;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceActions;
import org.robotui.ui.ViewAction;

/** What the title line offers: the same objects for every control that is made. Display thread. */
public final class SceneActions {
  private final SurfaceActions<SceneSurface> made = new SurfaceActions<>();
  private final List<ViewAction> all;

  /**
   * The actions of a view.
   *
   * @param reset has what belongs to the time before forgotten
   */
  public SceneActions(Runnable reset) {
    all = List.of(
        made.switched("follow", "Follow a frame\u2026", Icon.FOLLOW, SceneSurface::following,
            s -> s.menus().follow(s.canvas())),
        made.action("fit", "Show all (0)", Icon.FIT, SceneSurface::fit),
        made.action("camera", "Camera and views (V)", Icon.EYE, s -> s.menus().camera(s.canvas())),
        tool(ToolKind.MEASURE, Icon.RULER),
        tool(ToolKind.GOAL, Icon.TARGET),
        tool(ToolKind.POSE, Icon.POSE),
        tool(ToolKind.WAYPOINTS, Icon.ROUTE),
        new ViewAction("reset", "Reset: forget transforms and trails", Icon.RESTART.id(), Optional.empty(), reset),
        made.action("screenshot", "Save a picture\u2026", Icon.CAMERA, s -> s.menus().screenshot(s.canvas())),
        made.switched("displays", "Displays (L)", Icon.LAYERS, SceneSurface::treeOpen, SceneSurface::toggleTree));
  }

  /** All actions. */
  public List<ViewAction> all() {
    return all;
  }

  void connect(SceneSurface shown) {
    made.connect(shown);
  }

  void disconnect(SceneSurface gone) {
    made.disconnect(gone);
  }

  private ViewAction tool(ToolKind kind, Icon icon) {
    return made.switched(kind.id(), kind.label(), icon, s -> s.tools().using(kind), s -> s.tools().toggle(kind));
  }
}
