package org.robotui.uic.map.internal.view;

import java.util.List;
import org.eclipse.swt.graphics.Color;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.scene.Painter;
import org.robotui.uic.map.internal.model.PastPlace;
import org.robotui.uic.map.internal.model.Team;

/** Paints where robots were at the time at which the user points, on the ways that they went. Display thread. */
record PastMarks(Team team) {
  private static final double RING = 8;
  private static final double CORE = 3;
  private static final double WAY = 0.55;
  private static final double LENGTH = 18;

  void paint(Painter painter, List<PastPlace> places) {
    places.forEach(place -> paint(painter, place));
    painter.opacity(1);
  }

  private void paint(Painter painter, PastPlace place) {
    Theme theme = painter.theme();
    Color color = team.isSeveral() ? theme.traces().get(place.number() % theme.traces().size())
        : theme.color(Role.TEXT);
    List<Vector3> way = place.spot().way();
    double[] xy = new double[2 * way.size()];
    for (int i = 0; i < way.size(); i++) {
      Vector3 at = place.fixedFromFrame().apply(way.get(i));
      xy[2 * i] = at.x();
      xy[2 * i + 1] = at.y();
    }
    painter.opacity(WAY).stroke(color).width(1).polyline(xy, way.size());
    RigidTransform robot = place.fixedFromFrame().times(place.spot().pose());
    double x = robot.translation().x();
    double y = robot.translation().y();
    double ahead = LENGTH / painter.viewport().scale();
    double yaw = robot.rotation().yaw();
    painter.opacity(1).stroke(color).fill(color).width(2);
    painter.circle(x, y, RING);
    painter.disc(x, y, CORE);
    painter.line(x, y, x + ahead * Math.cos(yaw), y + ahead * Math.sin(yaw));
  }
}
