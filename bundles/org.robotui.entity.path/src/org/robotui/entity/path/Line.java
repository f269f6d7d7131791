package org.robotui.entity.path;

import java.util.Optional;
import java.util.stream.DoubleStream;
import org.robotui.data.navigation.Path;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.Bounds;

/**
 * A way in the fixed frame.
 *
 * @param xy x and y in turn, metres
 * @param length along the way, metres
 * @param bounds of all its points
 */
record Line(double[] xy, double length, Bounds bounds) {
  /** None where the path has no finite point. */
  static Optional<Line> of(Path path, RigidTransform fixedFromFrame) {
    double[] xy = path.poses().stream()
        .map(pose -> fixedFromFrame.apply(pose.translation()))
        .filter(Vector3::isFinite)
        .flatMapToDouble(p -> DoubleStream.of(p.x(), p.y()))
        .toArray();
    return xy.length == 0 ? Optional.empty() : Optional.of(new Line(xy, length(xy, 0), Bounds.of(xy)));
  }

  int count() {
    return xy.length / 2;
  }

  double endX() {
    return xy[xy.length - 2];
  }

  double endY() {
    return xy[xy.length - 1];
  }

  double distance(double x, double y) {
    int nearest = nearest(x, y);
    return Math.hypot(xy[2 * nearest] - x, xy[2 * nearest + 1] - y);
  }

  /** What is left of the way for somebody at a place. */
  double lengthFrom(double x, double y) {
    return distance(x, y) + length(xy, nearest(x, y));
  }

  private int nearest(double x, double y) {
    int nearest = 0;
    double best = Double.POSITIVE_INFINITY;
    for (int i = 0; i < count(); i++) {
      double distance = Math.hypot(xy[2 * i] - x, xy[2 * i + 1] - y);
      if (distance < best) {
        best = distance;
        nearest = i;
      }
    }
    return nearest;
  }

  private static double length(double[] xy, int from) {
    double length = 0;
    for (int i = from + 1; i < xy.length / 2; i++) {
      length += Math.hypot(xy[2 * i] - xy[2 * i - 2], xy[2 * i + 1] - xy[2 * i - 1]);
    }
    return length;
  }
}
