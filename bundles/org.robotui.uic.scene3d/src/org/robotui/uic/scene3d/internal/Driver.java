package org.robotui.uic.scene3d.internal;

import java.util.Optional;
import org.robotui.api.UicContext;
import org.robotui.api.config.Settings;
import org.robotui.geometry.RigidTransform;
import org.robotui.uic.scene3d.internal.model.Bases;
import org.robotui.uic.scene3d.internal.waypoint.Route;
import org.robotui.uic.scene3d.internal.waypoint.Waypoints;

/** Keeps the robot driving along the waypoints, whether the scene is seen or not. Worker thread. */
final class Driver {
  private final UicContext context;
  private final Waypoints waypoints;

  Driver(UicContext context, Waypoints waypoints) {
    this.context = context;
    this.waypoints = waypoints;
  }

  void tick(long nowNanos) {
    if (!waypoints.tour().busy()) {
      return;
    }
    Settings settings = context.settings().current();
    Route route = waypoints.route();
    String robot = context.output(ScenePorts.GOAL).authority().robot();
    Optional<RigidTransform> base = route.frame().flatMap(frame -> Bases.in(frame, robot, context.frames(), settings));
    waypoints.tour().tick(route, base, settings.number(SceneOptions.WAYPOINT_TOLERANCE), nowNanos);
  }
}
