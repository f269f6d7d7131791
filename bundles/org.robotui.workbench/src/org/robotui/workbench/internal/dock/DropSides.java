package org.robotui.workbench.internal.dock;

import java.util.Comparator;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.api.layout.Edge;

/** Which part of a place the pointer is in, and which part of it what is dropped there would take. */
final class DropSides {
  private static final double NEAR = 0.28;

  private DropSides() {}

  /** The side of a rectangle that a point in it is near to; none in the middle. */
  static Optional<Edge> side(Rectangle place, Point at) {
    if (place.width <= 0 || place.height <= 0) {
      return Optional.empty();
    }
    double x = (at.x - place.x) / (double) place.width;
    double y = (at.y - place.y) / (double) place.height;
    return nearest(distances(x, 1 - x, y, 1 - y), NEAR);
  }

  /** The side of a rectangle to which a point is no further than some pixels. */
  static Optional<Edge> border(Rectangle place, Point at, int pixels) {
    return nearest(distances(at.x - place.x, place.x + place.width - at.x, at.y - place.y,
        place.y + place.height - at.y), pixels);
  }

  /** The part of a rectangle at one of its sides. */
  static Rectangle part(Rectangle whole, Edge edge, double share) {
    int width = (int) (whole.width * share);
    int height = (int) (whole.height * share);
    return switch (edge) {
      case LEFT -> new Rectangle(whole.x, whole.y, width, whole.height);
      case RIGHT -> new Rectangle(whole.x + whole.width - width, whole.y, width, whole.height);
      case TOP -> new Rectangle(whole.x, whole.y, whole.width, height);
      case BOTTOM -> new Rectangle(whole.x, whole.y + whole.height - height, whole.width, height);
    };
  }

  private static Map<Edge, Double> distances(double left, double right, double top, double bottom) {
    return new EnumMap<>(Map.of(Edge.LEFT, left, Edge.RIGHT, right, Edge.TOP, top, Edge.BOTTOM, bottom));
  }

  private static Optional<Edge> nearest(Map<Edge, Double> distances, double limit) {
    return distances.entrySet().stream().filter(e -> e.getValue() >= 0)
        .min(Comparator.comparingDouble(Map.Entry::getValue)).filter(e -> e.getValue() < limit).map(Map.Entry::getKey);
  }
}
