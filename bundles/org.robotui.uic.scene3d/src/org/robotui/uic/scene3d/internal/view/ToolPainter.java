package org.robotui.uic.scene3d.internal.view;

import java.util.List;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.uic.scene3d.internal.camera.Lens;

/** Paints what tools have marked. Display thread. */
final class ToolPainter {
  private static final int DOT = 7;
  private static final double ARROW_SHARE = 0.07;
  private static final double HEAD = 0.3;

  private final Theme theme;
  private final StateView states;

  ToolPainter(Theme theme, StateView states) {
    this.theme = theme;
    this.states = states;
  }

  void paint(GC gc, Rectangle area, Lens lens, Tools tools) {
    List<Point> ends = tools.stretched();
    if (ends.isEmpty()) {
      measured(gc, lens, tools.measured());
    } else {
      line(gc, ends);
    }
    tools.pose().ifPresent(pose -> arrow(gc, lens, pose, tools.using(ToolKind.POSE) ? Role.WARNING : Role.PLAN));
    tools.toast().at(System.nanoTime()).ifPresentOrElse(t -> states.banner(gc, area, t.health(), t.text()),
        () -> tools.hint().ifPresent(words -> states.banner(gc, area, Health.NONE, words)));
  }

  /** Distance, and its parts along the axes. */
  static String words(Vector3 from, Vector3 to) {
    Vector3 d = to.minus(from);
    return Figures.of(d.norm(), 3, "m") + "   \u0394x " + Figures.fixed(d.x(), 3) + "  \u0394y "
        + Figures.fixed(d.y(), 3)
        + "  \u0394z " + Figures.of(d.z(), 3, "m");
  }

  private void measured(GC gc, Lens lens, List<Vector3> places) {
    List<Point> points = places.stream().flatMap(p -> SceneOverlay.point(lens, p).stream()).toList();
    line(gc, points);
    if (points.size() == 2) {
      label(gc, words(places.get(0), places.get(1)), (points.get(0).x + points.get(1).x) / 2,
          (points.get(0).y + points.get(1).y) / 2);
    }
  }

  private void line(GC gc, List<Point> points) {
    gc.setForeground(theme.color(Role.ACCENT));
    gc.setBackground(theme.color(Role.ACCENT));
    gc.setLineWidth(2);
    if (points.size() == 2) {
      gc.drawLine(points.get(0).x, points.get(0).y, points.get(1).x, points.get(1).y);
    }
    points.forEach(p -> gc.fillOval(p.x - DOT / 2, p.y - DOT / 2, DOT, DOT));
    gc.setLineWidth(1);
  }

  private void label(GC gc, String words, int x, int y) {
    gc.setFont(theme.font(Face.FIGURES));
    Point size = gc.textExtent(words);
    Rectangle pill = new Rectangle(x - size.x / 2 - 2 * Theme.STEP, y + 3 * Theme.STEP, size.x + 4 * Theme.STEP,
        size.y + 2 * Theme.STEP);
    states.pill(gc, pill);
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText(words, pill.x + 2 * Theme.STEP, pill.y + Theme.STEP, true);
  }

  /** An arrow that lies on the floor. */
  private void arrow(GC gc, Lens lens, RigidTransform pose, Role role) {
    double length = lens.pose().height() * ARROW_SHARE * 2;
    Vector3[] shape =
        {new Vector3(0, 0, 0), new Vector3(length, 0, 0), new Vector3(length * (1 - HEAD), length * HEAD, 0),
            new Vector3(length * (1 - HEAD), -length * HEAD, 0)};
    Point[] p = new Point[shape.length];
    for (int i = 0; i < shape.length; i++) {
      p[i] = SceneOverlay.point(lens, pose.apply(shape[i])).orElse(new Point(-1, -1));
    }
    gc.setForeground(theme.color(role));
    gc.setBackground(theme.color(role));
    gc.setLineWidth(3);
    gc.drawLine(p[0].x, p[0].y, p[1].x, p[1].y);
    gc.fillPolygon(new int[]{p[1].x, p[1].y, p[2].x, p[2].y, p[3].x, p[3].y});
    gc.fillOval(p[0].x - DOT / 2, p[0].y - DOT / 2, DOT, DOT);
    gc.setLineWidth(1);
    label(gc, Figures.degrees(pose.rotation().yaw(), 0), p[0].x, p[0].y);
  }
}
