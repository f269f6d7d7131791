package org.robotui.entity.bumper;

import java.util.List;
import java.util.Optional;
import org.robotui.data.sensor.Bumper;
import org.robotui.entity.bumper.internal.Rim;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.Bounds;

/**
 * A bumper in the fixed frame.
 *
 * @param index as its robot counts, from 0
 * @param pressed whether something touches it
 * @param line x and y along it in turn
 */
record Strip(int index, boolean pressed, double[] line) {
  /** None where its place is not known. */
  static Optional<Strip> of(int index, Bumper bumper, RigidTransform fixedFromFrame) {
    RigidTransform fixedFromBumper = fixedFromFrame.times(bumper.pose());
    List<Vector3> points = Rim.of(bumper).stream().map(fixedFromBumper::apply).toList();
    double[] line = new double[2 * points.size()];
    for (int i = 0; i < points.size(); i++) {
      line[2 * i] = points.get(i).x();
      line[2 * i + 1] = points.get(i).y();
    }
    return points.isEmpty() ? Optional.empty() : Optional.of(new Strip(index, bumper.pressed(), line));
  }

  Bounds bounds() {
    return Bounds.of(line);
  }

  double distance(double x, double y) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i + 3 < line.length; i += 2) {
      nearest =
          Math.min(nearest, distance(x - line[i], y - line[i + 1], line[i + 2] - line[i], line[i + 3] - line[i + 1]));
    }
    return nearest;
  }

  /** From a point to the line from the origin to another. */
  private static double distance(double x, double y, double dx, double dy) {
    double square = dx * dx + dy * dy;
    double along = square > 0 ? Math.clamp((x * dx + y * dy) / square, 0.0, 1.0) : 0;
    return Math.hypot(x - along * dx, y - along * dy);
  }
}
