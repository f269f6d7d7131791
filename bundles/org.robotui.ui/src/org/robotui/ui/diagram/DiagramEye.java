package org.robotui.ui.diagram;

import java.util.Optional;

/**
 * What of a diagram is seen: zoom and shift. Until it is moved by hand it shows all, or, where that would be too small
 * to read, the first box and what is around it. Display thread.
 */
final class DiagramEye {
  private static final double LEAST = 0.02;
  private static final double MOST = 4;
  private static final double READABLE = 0.85;
  private static final int MARGIN = 16;

  private double zoom = 1;
  private double left;
  private double top;
  private boolean moved;
  private boolean whole;

  /** What is to be seen, before each paint. */
  void settle(Diagram diagram, int width, int height) {
    if (!moved) {
      double fits = Math.min((width - 2.0 * MARGIN) / Math.max(1, diagram.width()),
          (height - 2.0 * MARGIN) / Math.max(1, diagram.height()));
      zoom = Math.clamp(fits, whole ? LEAST : READABLE, 1);
      Optional<Box> first = diagram.boxes().stream().findFirst();
      left = along(width, diagram.width(), first.map(box -> box.x() + box.width() / 2).orElse(0.0));
      top = along(height, diagram.height(), first.map(box -> box.y() + box.height() / 2).orElse(0.0));
    }
  }

  /**
   * In the middle where it fits, else with the first box as near to the middle as can be without leaving room at an
   * end.
   */
  private double along(int room, double length, double first) {
    double spare = room - length * zoom;
    return spare >= 2 * MARGIN ? spare / 2
        : Math.clamp(room / 2.0 - first * zoom, Math.min(spare - MARGIN, MARGIN), MARGIN);
  }

  /** Shows all, as small as need be. */
  void fit() {
    moved = false;
    whole = true;
  }

  boolean moved() {
    return moved;
  }

  void pan(double dx, double dy) {
    moved = true;
    left += dx;
    top += dy;
  }

  void zoom(double x, double y, double factor) {
    moved = true;
    double next = Math.clamp(zoom * factor, LEAST, MOST);
    left = x - (x - left) * next / zoom;
    top = y - (y - top) * next / zoom;
    zoom = next;
  }

  /** Brings a box into sight, where it is not. */
  void reveal(Box box, int width, int height) {
    double x = left + (box.x() + box.width() / 2) * zoom;
    double y = top + (box.y() + box.height() / 2) * zoom;
    if (x < 0 || y < 0 || x >= width || y >= height) {
      pan(width / 2.0 - x, height / 2.0 - y);
    }
  }

  double zoom() {
    return zoom;
  }

  double left() {
    return left;
  }

  double top() {
    return top;
  }

  double diagramX(double x) {
    return (x - left) / zoom;
  }

  double diagramY(double y) {
    return (y - top) / zoom;
  }
}
