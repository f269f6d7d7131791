package org.robotui.entity.reach.internal;

import java.util.Optional;
import org.robotui.ui.Role;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Ink;
import org.robotui.ui.scene.Painter;

/** What is painted. A worker publishes it as one immutable value, and the display thread paints the last. */
final class ReachEntity implements Entity {

  private static final double WIDTH = 3;

  /** A line of points, x and y in turn, and its colour. */
  private record Curve(double[] xy, Ink ink) {

    double distance(double x, double y) {
      double least = Double.POSITIVE_INFINITY;
      for (int i = 0; i < xy.length; i += 2) {
        least = Math.min(least, Math.hypot(xy[i] - x, xy[i + 1] - y));
      }
      return least;
    }
  }

  private volatile Optional<Curve> shown = Optional.empty();

  /** Takes a line in place of the one before. Worker thread. */
  void prepare(double[] xy, Ink ink) {
    shown = Optional.of(new Curve(xy, ink));
  }

  @Override
  public void paint(Painter painter) {
    shown.ifPresent(curve -> {
      painter.stroke(curve.ink().of(painter.theme(), Role.PLAN)).width(WIDTH);
      painter.polyline(curve.xy(), curve.xy().length / 2);
    });
  }

  @Override
  public Optional<Bounds> bounds() {
    return shown.map(curve -> Bounds.of(curve.xy()));
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return shown.map(curve -> new Description("where the robot will go", curve.distance(x, y)))
        .filter(at -> at.distance() <= tolerance);
  }
}
