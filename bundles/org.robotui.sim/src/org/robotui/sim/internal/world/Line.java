package org.robotui.sim.internal.world;

/**
 * A line in the plane, metres.
 *
 * @param x1 start
 * @param y1 start
 * @param x2 end
 * @param y2 end
 */
public record Line(double x1, double y1, double x2, double y2) {
  public double length() {
    return Math.hypot(x2 - x1, y2 - y1);
  }

  /** The part between two distances from the start; they may lie outside of the line. */
  public Line part(double from, double to) {
    double ux = (x2 - x1) / length();
    double uy = (y2 - y1) / length();
    return new Line(x1 + from * ux, y1 + from * uy, x1 + to * ux, y1 + to * uy);
  }

  public Line extended(double by) {
    return part(-by, length() + by);
  }
}
