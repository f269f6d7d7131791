package org.robotui.ui.scene;

/**
 * Leaves out the points of a long line that lie as good as between others, as most of a way do that was driven. One
 * pass: from the last point that is kept, the directions that pass all points since then form a cone, which each
 * further point narrows; one outside it has the point before it kept.
 */
final class LineThinner {
  private final double[] xy;
  private final double tolerance;
  private int kept = 1;
  private double anchorX;
  private double anchorY;
  private double farthest;
  /** Edges of the cone, right and left; none as long as all points lie at its tip. */
  private boolean cone;
  private double rightX;
  private double rightY;
  private double leftX;
  private double leftY;

  private LineThinner(double[] xy, double tolerance) {
    this.xy = xy;
    this.tolerance = tolerance;
  }

  /**
   * Thins a line in place.
   *
   * @param xy x and y in turn; the points that are kept are moved to its front
   * @param count how many points of it
   * @param tolerance how far a point that is left out may lie from the line that is left
   * @return how many are kept, the first and the last among them
   */
  static int thin(double[] xy, int count, double tolerance) {
    return count < 3 ? count : new LineThinner(xy, tolerance).thin(count);
  }

  private int thin(int count) {
    begin(xy[0], xy[1]);
    for (int i = 1; i < count; i++) {
      if (!passes(xy[2 * i], xy[2 * i + 1])) {
        keep(i - 1);
      }
      narrow(xy[2 * i] - anchorX, xy[2 * i + 1] - anchorY);
    }
    keep(count - 1);
    return kept;
  }

  private void begin(double x, double y) {
    anchorX = x;
    anchorY = y;
    farthest = 0;
    cone = false;
  }

  private void keep(int index) {
    double x = xy[2 * index];
    double y = xy[2 * index + 1];
    xy[2 * kept] = x;
    xy[2 * kept + 1] = y;
    kept++;
    begin(x, y);
  }

  /** A line that comes back turns at a point that must be kept. */
  private boolean passes(double x, double y) {
    double dx = x - anchorX;
    double dy = y - anchorY;
    return (!cone || rightX * dy - rightY * dx >= 0 && dx * leftY - dy * leftX >= 0)
        && Math.hypot(dx, dy) >= farthest - tolerance;
  }

  private void narrow(double dx, double dy) {
    double distance = Math.hypot(dx, dy);
    farthest = Math.max(farthest, distance);
    if (distance > tolerance) {
      double sine = tolerance / distance;
      double cosine = Math.sqrt(1 - sine * sine);
      narrow(dx * cosine + dy * sine, dy * cosine - dx * sine, dx * cosine - dy * sine, dy * cosine + dx * sine);
    }
  }

  private void narrow(double toRightX, double toRightY, double toLeftX, double toLeftY) {
    if (!cone || rightX * toRightY - rightY * toRightX > 0) {
      rightX = toRightX;
      rightY = toRightY;
    }
    if (!cone || leftX * toLeftY - leftY * toLeftX < 0) {
      leftX = toLeftX;
      leftY = toLeftY;
    }
    cone = true;
  }
}
